// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/registration_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "roomcast/geometry/color_projection.h"

namespace roomcast {
namespace {

using Eigen::Vector3d;

constexpr double kNothing = std::numeric_limits<double>::infinity();

int cell_of(double position, int cell_size) {
  return static_cast<int>((position + 0.5 + 1e-4 * cell_size) / cell_size);
}

/// Mean of the N x N square around (u, v), shifted inside the picture.
Rgb8 box_average(ColorView picture, double u, double v, int size) {
  const double left = std::clamp(u - 0.5 * (size - 1), 0.0, double(picture.width - size));
  const double top = std::clamp(v - 0.5 * (size - 1), 0.0, double(picture.height - size));
  const int x0 = std::min(int(left), picture.width - size - 1);
  const int y0 = std::min(int(top), picture.height - size - 1);
  Vector3d sum = Vector3d::Zero();
  for (int j = 0; j <= size; ++j) {
    const double row_weight = j == 0 ? 1 - (top - y0) : j == size ? top - y0 : 1;
    for (int i = 0; i <= size; ++i) {
      const double weight = i == 0 ? 1 - (left - x0) : i == size ? left - x0 : 1;
      const Rgb8 color = picture.at(x0 + i, y0 + j);
      sum += row_weight * weight * Vector3d(color.r, color.g, color.b);
    }
  }
  const Vector3d mean = sum / (size * size) + Vector3d::Constant(0.5);
  return {std::uint8_t(mean.x()), std::uint8_t(mean.y()), std::uint8_t(mean.z())};
}

/// Slope along one axis: depth change to the next pixel, mm; 0 at a peak or in a pit.
double slope(DepthView depth_mm, int x, int y, int dx, int dy) {
  const auto inside = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < depth_mm.width && j < depth_mm.height;
  };
  const double z = depth_mm.at(x, y);
  std::optional<double> before, after;
  if (inside(x - dx, y - dy)) before = z - depth_mm.at(x - dx, y - dy);
  if (inside(x + dx, y + dy)) after = depth_mm.at(x + dx, y + dy) - z;
  if (!before) before = after;
  if (!after) after = before;
  if ((*before < 0) != (*after < 0)) return 0;
  return std::min(std::abs(*before), std::abs(*after));
}

}  // namespace

RegistrationReference::RegistrationReference(const SensorCalibration& calibration,
                                             const RegistrationOptions& options)
    : calibration_(calibration), options_(options), rays_(ray_table(calibration.depth)) {
  const auto spacing = ColorProjection(calibration).spacing();
  cell_size_ = std::clamp(int(std::ceil(std::max(spacing.typical, spacing.largest / 2))), 1, 64);
  box_size_ = std::clamp(int(std::lround(spacing.typical)), 1, kLargestBox);
}

Image<Vector3d> RegistrationReference::project_all(DepthView depth_mm) const {
  const CameraIntrinsics& color = calibration_.color;
  Image<Vector3d> projected(depth_mm.width, depth_mm.height, Vector3d::Zero());
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const Vector3d ray(rays_.at(x, y).x(), rays_.at(x, y).y(), 1);
      const Vector3d point = calibration_.color_from_depth * (0.001 * depth_mm.at(x, y) * ray);
      const auto pixel = project(color, point);
      if (depth_mm.at(x, y) == 0 || !pixel) continue;
      if (pixel->x() < -0.5 || pixel->y() < -0.5) continue;
      if (pixel->x() > color.width - 0.5 || pixel->y() > color.height - 0.5) continue;
      projected.at(x, y) = {pixel->x(), pixel->y(), point.z()};
    }
  }
  return projected;
}

Image<double> RegistrationReference::nearest_surfaces(const Image<Vector3d>& projected) const {
  Image<double> nearest(calibration_.color.width / cell_size_ + 2,
                        calibration_.color.height / cell_size_ + 2, kNothing);
  for (int y = 0; y < projected.height(); ++y) {
    for (int x = 0; x < projected.width(); ++x) {
      const Vector3d& uvz = projected.at(x, y);
      if (!(uvz.z() > 0)) continue;
      double& cell = nearest.at(cell_of(uvz.x(), cell_size_), cell_of(uvz.y(), cell_size_));
      cell = std::min(cell, uvz.z());
    }
  }
  return nearest;
}

bool RegistrationReference::occluded(DepthView depth_mm, int x, int y, const Vector3d& projected,
                                     const Image<double>& nearest) const {
  const double slope_m =
      0.001 * std::min(2 * (slope(depth_mm, x, y, 1, 0) + slope(depth_mm, x, y, 0, 1)),
                       std::floor(depth_mm.at(x, y) / 8.0));
  const double limit_m =
      projected.z() * (1 - options_.occlusion_margin_per_m) - options_.occlusion_margin_m - slope_m;
  const int column = cell_of(projected.x(), cell_size_);
  const int row = cell_of(projected.y(), cell_size_);
  for (int j = std::max(row - 1, 0); j <= std::min(row + 1, nearest.height() - 1); ++j) {
    for (int i = std::max(column - 1, 0); i <= std::min(column + 1, nearest.width() - 1); ++i) {
      if (nearest.at(i, j) < limit_m) return true;
    }
  }
  return false;
}

RegisteredColor RegistrationReference::run(DepthView depth_mm, ColorView color) const {
  RegisteredColor out{ColorImage(depth_mm.width, depth_mm.height),
                      MaskImage(depth_mm.width, depth_mm.height)};
  const Image<Vector3d> projected = project_all(depth_mm);
  const Image<double> nearest = nearest_surfaces(projected);
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const Vector3d& uvz = projected.at(x, y);
      if (!(uvz.z() > 0) || occluded(depth_mm, x, y, uvz, nearest)) continue;
      out.color.at(x, y) = box_average(color, uvz.x(), uvz.y(), box_size_);
      out.seen.at(x, y) = 255;
    }
  }
  return out;
}

}  // namespace roomcast
