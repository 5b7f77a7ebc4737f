// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/color_projection.h"

#include <algorithm>
#include <cmath>

namespace roomcast {
namespace {

constexpr float kMetresPerMillimetre = 0.001F;
constexpr float kNearestZ_m = 0.01F;           // no surface is closer to a colour camera
constexpr std::uint16_t kFarDepth_mm = 50000;  // the baseline is negligible here

}  // namespace

ColorProjection::Lens ColorProjection::lens_of(const SensorCalibration& calibration) {
  const CameraIntrinsics& c = calibration.color;
  const Eigen::Vector3f t = calibration.color_from_depth.translation_m.cast<float>();
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(c.fx), f(c.fy), f(c.cx),          f(c.cy),           f(c.k1),
          f(c.k2), f(c.k3), f(c.p1),          f(c.p2),           t.x(),
          t.y(),   t.z(),   f(c.width - 0.5), f(c.height - 0.5), f(widest_radius_squared(c))};
}

ColorProjection::ColorProjection(const SensorCalibration& calibration)
    : width_(calibration.depth.width),
      height_(calibration.depth.height),
      lens_(lens_of(calibration)) {
  const Eigen::Matrix3f rotation = calibration.color_from_depth.rotation.cast<float>();
  const auto rays = ray_table(calibration.depth);
  const std::size_t count = rays.view().pixel_count();
  direction_x_.resize(count);
  direction_y_.resize(count);
  direction_z_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2f& ray = rays.data()[i];
    const Eigen::Vector3f direction = rotation * Eigen::Vector3f(ray.x(), ray.y(), 1);
    direction_x_[i] = direction.x();
    direction_y_[i] = direction.y();
    direction_z_[i] = direction.z();
  }
}

void ColorProjection::project_row(const std::uint16_t* depth_mm, int y,
                                  const ProjectedRow& out) const {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  project_pixels(lens_, width_, depth_mm, &direction_x_[start], &direction_y_[start],
                 &direction_z_[start], out.u, out.v, out.z_m);
}

/// The rows are parameters because GCC honours __restrict on parameters only. Of local pointers it
/// checks at run time whether they overlap; these are twelve pairs, more than its limit of ten, and
/// it would not vectorise the loop.
void ColorProjection::project_pixels(const Lens& lens, int width,
                                     const std::uint16_t* __restrict depth_mm,
                                     const float* __restrict ax, const float* __restrict ay,
                                     const float* __restrict az, float* __restrict u_px,
                                     float* __restrict v_px, float* __restrict z_m) {
  const Lens l = lens;
  for (int i = 0; i < width; ++i) {
    const float depth_m = kMetresPerMillimetre * static_cast<float>(depth_mm[i]);
    const float z = depth_m * az[i] + l.tz_m;
    const float x = (depth_m * ax[i] + l.tx_m) / z;
    const float y_n = (depth_m * ay[i] + l.ty_m) / z;
    const float r2 = x * x + y_n * y_n;
    const float radial = 1 + r2 * (l.k1 + r2 * (l.k2 + r2 * l.k3));
    const float xy2 = 2 * x * y_n;
    const float u = l.fx * (x * radial + l.p1 * xy2 + l.p2 * (r2 + 2 * x * x)) + l.cx;
    const float v = l.fy * (y_n * radial + l.p1 * (r2 + 2 * y_n * y_n) + l.p2 * xy2) + l.cy;
    const bool seen = (depth_m > 0) & (z > kNearestZ_m) & (r2 <= l.largest_r2) & (u >= -0.5F) &
                      (v >= -0.5F) & (u <= l.largest_u) & (v <= l.largest_v);
    u_px[i] = seen ? u : 0.0F;
    v_px[i] = seen ? v : 0.0F;
    z_m[i] = seen ? z : 0.0F;
  }
}

ColorProjection::Spacing ColorProjection::spacing() const {
  const std::size_t width = static_cast<std::size_t>(width_);
  const std::vector<std::uint16_t> far(width, kFarDepth_mm);
  std::vector<float> u(width), v(width), z(width), above_u(width), above_v(width), above_z(width);
  std::vector<float> distances;
  const auto add = [&](float du, float dv) { distances.push_back(std::hypot(du, dv)); };
  for (int y = 0; y < height_; ++y) {
    std::swap(u, above_u), std::swap(v, above_v), std::swap(z, above_z);
    project_row(far.data(), y, {u.data(), v.data(), z.data()});
    for (std::size_t x = 1; x < width; ++x) {
      if (z[x] > 0 && z[x - 1] > 0) add(u[x] - u[x - 1], v[x] - v[x - 1]);
      if (z[x] > 0 && above_z[x] > 0) add(u[x] - above_u[x], v[x] - above_v[x]);
    }
  }
  if (distances.empty()) return {};
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return {*middle, *std::max_element(distances.begin(), distances.end())};
}

}  // namespace roomcast
