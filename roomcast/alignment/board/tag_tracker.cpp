// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/tag_tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "roomcast/alignment/board/tag_detector.h"
#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

constexpr std::size_t kMinReadings = 25;
constexpr double kMinIncidence = 0.35;  // cosine
constexpr double kSidesAlike = 0.15;    // relative difference of the sides of a square

using Pixels = std::array<Eigen::Vector2d, 4>;

struct DepthPlane {
  Eigen::Vector3d normal, at_m;
};

bool is_inside(const Pixels& quad, const Eigen::Vector2d& pixel) {
  int left = 0;
  for (std::size_t i = 0; i < quad.size(); ++i) {
    const Eigen::Vector2d side = quad[(i + 1) % 4] - quad[i], to = pixel - quad[i];
    left += side.x() * to.y() - side.y() * to.x() > 0;
  }
  return left == 0 || left == 4;
}

DepthPlane plane_through(const std::vector<Eigen::Vector3d>& points_m) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points_m) mean += point / static_cast<double>(points_m.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& point : points_m) spread += (point - mean) * (point - mean).transpose();
  return {thinnest_direction(spread), mean};
}

/// Fits a plane without the farthest outliers: flying pixels, fingers.
std::optional<DepthPlane> steady_plane(std::vector<Eigen::Vector3d> points_m) {
  constexpr int kRounds = 3;
  constexpr double kKept = 0.85;
  for (int round = 0; round < kRounds; ++round) {
    if (points_m.size() < kMinReadings) return std::nullopt;
    const DepthPlane plane = plane_through(points_m);
    const auto off = [&](const Eigen::Vector3d& p) {
      return std::abs(plane.normal.dot(p - plane.at_m));
    };
    const auto kept = static_cast<std::ptrdiff_t>(kKept * static_cast<double>(points_m.size()));
    std::nth_element(points_m.begin(), points_m.begin() + kept, points_m.end(),
                     [&](const auto& a, const auto& b) { return off(a) < off(b); });
    points_m.resize(static_cast<std::size_t>(kept));
  }
  const DepthPlane plane = plane_through(points_m);
  if (std::abs(plane.normal.dot(plane.at_m.normalized())) < kMinIncidence) return std::nullopt;
  return plane;
}

bool is_square(const std::array<Eigen::Vector3d, 4>& corners_m) {
  double shortest = 1e9, longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = (corners_m[(i + 1) % 4] - corners_m[i]).norm();
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  return shortest > (1 - kSidesAlike) * longest;
}

}  // namespace

struct TagTracker::Detector {
  SensorCalibration calibration;
  Image<Eigen::Vector2f> rays;  // of the depth camera
  TagDetector outlines;

  explicit Detector(const SensorCalibration& cameras)
      : calibration(cameras), rays(ray_table(cameras.depth)) {}

  /// In the colour camera's frame.
  [[nodiscard]] std::vector<Eigen::Vector3d> readings_on(const Pixels& quad,
                                                         DepthView depth_mm) const {
    std::vector<Eigen::Vector3d> points_m;
    for (int y = 0; y < depth_mm.height; ++y) {
      for (int x = 0; x < depth_mm.width; ++x) {
        const double z_m = 0.001 * depth_mm.at(x, y);
        const Eigen::Vector2f& ray = rays.at(x, y);
        if (!(z_m > 0) || std::isnan(ray.x())) continue;
        const Eigen::Vector3d point =
            calibration.color_from_depth * (z_m * ray.cast<double>().homogeneous());
        const auto pixel = project(calibration.color, point);
        if (pixel && is_inside(quad, *pixel)) points_m.push_back(point);
      }
    }
    return points_m;
  }

  [[nodiscard]] std::optional<SeenTag> lift(const TagOutline& found, DepthView depth_mm) const {
    const Pixels& quad = found.corners_px;
    const auto plane = steady_plane(readings_on(quad, depth_mm));
    if (!plane) return std::nullopt;
    SeenTag tag{found.id, {}};
    const RigidTransform depth_from_color = calibration.color_from_depth.inverse();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ray = unproject(calibration.color, quad[i], 1);
      if (!ray) return std::nullopt;
      const double z_m = plane->normal.dot(plane->at_m) / plane->normal.dot(*ray);
      tag.corners_m[i] = depth_from_color * (z_m * *ray);
    }
    if (!is_square(tag.corners_m)) return std::nullopt;
    return tag;
  }
};

TagTracker::TagTracker(const SensorCalibration& calibration)
    : detector_(std::make_unique<Detector>(calibration)) {}
TagTracker::~TagTracker() = default;
TagTracker::TagTracker(TagTracker&&) noexcept = default;
TagTracker& TagTracker::operator=(TagTracker&&) noexcept = default;

std::vector<SeenTag> TagTracker::find(DepthView depth_mm, ColorView color) {
  std::vector<SeenTag> tags;
  for (const TagOutline& outline : detector_->outlines.find(color)) {
    if (auto tag = detector_->lift(outline, depth_mm)) tags.push_back(*tag);
  }
  return tags;
}

}  // namespace roomcast::alignment
