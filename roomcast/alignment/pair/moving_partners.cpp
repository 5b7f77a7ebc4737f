// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_partners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

/// The blocks of an instant, with a factor on the readings.
struct Blocks {
  const SensorView& view;
  const DepthInstant& instant;
  float scale;

  [[nodiscard]] bool moving(int x, int y) const { return instant.moving.at(x, y) != 0; }
  [[nodiscard]] Eigen::Vector3f point(int x, int y) const {
    const float z_m = 0.001F * scale * static_cast<float>(instant.depth_mm.at(x, y));
    return z_m * view.block_rays.at(x, y).homogeneous();
  }
  /// From the four blocks around, where all of them move.
  [[nodiscard]] std::optional<SurfacePoint> surface(int x, int y) const {
    if (x < 1 || y < 1 || x + 1 >= instant.moving.width() || y + 1 >= instant.moving.height())
      return std::nullopt;
    if (!moving(x, y) || !moving(x - 1, y) || !moving(x + 1, y) || !moving(x, y - 1) ||
        !moving(x, y + 1))
      return std::nullopt;
    const Eigen::Vector3f across = point(x + 1, y) - point(x - 1, y);
    const Eigen::Vector3f down = point(x, y + 1) - point(x, y - 1);
    const SurfacePoint here{point(x, y), down.cross(across).normalized()};
    return here.normal.hasNaN() || here.point_m.hasNaN() ? std::nullopt : std::optional(here);
  }
};

/// Calls visit(of_source, of_target) for the points of the source that the target shows too.
template <class Visit>
void for_each_moving_partner(const Blocks& source, const Blocks& target,
                             const RigidTransform& target_from_source, float reach_m,
                             const MovingPartnerOptions& options, Visit visit) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation_m.cast<float>();
  const float slide_m = options.slide_per_reach * reach_m;
  for (int y = 1; y + 1 < source.instant.moving.height(); ++y) {
    for (int x = 1; x + 1 < source.instant.moving.width(); ++x) {
      const auto of_source = source.surface(x, y);
      if (!of_source) continue;
      const Eigen::Vector3f point = rotation * of_source->point_m + shift;
      Eigen::Vector2f pixel;
      if (!target.view.surface.lens.project(point, pixel)) continue;
      const auto of_target =
          target.surface(static_cast<int>(std::floor(pixel.x() / kInstantBlock)),
                         static_cast<int>(std::floor(pixel.y() / kInstantBlock)));
      if (!of_target) continue;
      const Eigen::Vector3f apart = point - of_target->point_m;
      const float residual_m = of_target->normal.dot(apart);
      if (std::abs(residual_m) > reach_m || apart.norm() > slide_m) continue;
      if (of_target->normal.dot(rotation * of_source->normal) < options.min_cosine) continue;
      visit(*of_source, *of_target, residual_m);
    }
  }
}

}  // namespace

MovingPartners moving_partners(const SensorView& a, double scale_a, const SensorView& b,
                               double scale_b, const RigidTransform& a_from_b, float reach_m,
                               const MovingPartnerOptions& options,
                               const MovingConsistencyOptions& moving) {
  MovingPartners found;
  const Eigen::Matrix3f rotation = a_from_b.rotation.cast<float>();
  for (const DepthInstant& instant : b.instants) {
    const DepthInstant* const other = instant_at(a.instants, instant.time_s, moving.max_apart_s);
    if (!other) continue;
    const Blocks of_a{a, *other, static_cast<float>(scale_a)};
    const Blocks of_b{b, instant, static_cast<float>(scale_b)};
    const double late_m = options.speed_m_s * (instant.time_s - other->time_s);
    const auto variance_m2 = [&](const SurfacePoint& in_a, const SurfacePoint& in_b) {
      const double sigma_a = a.surface.options.noise.sigma_m(in_a.point_m.z());
      const double sigma_b = b.surface.options.noise.sigma_m(in_b.point_m.z());
      return static_cast<float>(0.5 * (sigma_a * sigma_a + sigma_b * sigma_b) + late_m * late_m +
                                options.surface_sigma_m * options.surface_sigma_m);
    };
    const std::size_t before = found.partners.size();
    for_each_moving_partner(of_b, of_a, a_from_b, reach_m, options,
                            [&](const SurfacePoint& in_b, const SurfacePoint& in_a, float m) {
                              found.partners.push_back({in_a.point_m, in_b.point_m, in_a.normal, m,
                                                        variance_m2(in_a, in_b)});
                            });
    for_each_moving_partner(
        of_a, of_b, a_from_b.inverse(), reach_m, options,
        [&](const SurfacePoint& in_a, const SurfacePoint& in_b, float m) {
          found.partners.push_back(
              {in_a.point_m, in_b.point_m, rotation * in_b.normal, -m, variance_m2(in_a, in_b)});
        });
    const auto here = static_cast<double>(found.partners.size() - before);
    found.independent += std::min(options.per_instant, here);
  }
  found.independent = std::min(found.independent, options.most);
  return found;
}

}  // namespace roomcast::alignment
