// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_partners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

/// One direction of a pair: points of `source` are looked up in `target`.
struct MovingDirection {
  const MovingSide& source;
  const MovingSide& target;
  Eigen::Matrix3f rotation;  // target from source
  Eigen::Vector3f shift;
  float reach_m;

  MovingDirection(const MovingSide& from, const MovingSide& to, const RigidTransform& to_from_from,
                  float reach)
      : source(from),
        target(to),
        rotation(to_from_from.rotation.cast<float>()),
        shift(to_from_from.translation_m.cast<float>()),
        reach_m(reach) {}
};

struct MovingPartner {
  const SurfacePoint* seen;  // by the target
  Eigen::Vector3f normal;    // mean of both, in the target's frame
  float residual_m;
};

const MovingSurface* surface_at_time(std::span<const MovingSurface> surfaces, double time_s,
                                     double max_apart_s) {
  const MovingSurface* nearest = nullptr;
  for (const MovingSurface& each : surfaces) {
    const double apart_s = std::abs(each.time_s - time_s);
    if (apart_s <= max_apart_s && (!nearest || apart_s < std::abs(nearest->time_s - time_s)))
      nearest = &each;
  }
  return nearest;
}

std::optional<MovingPartner> partner_of(const SurfacePoint& of_source, const MovingDirection& way,
                                        const MovingSurface& surface,
                                        const MovingPartnerOptions& options) {
  const auto scale_from = static_cast<float>(way.source.scale);
  const auto scale_to = static_cast<float>(way.target.scale);
  const Eigen::Vector3f point = way.rotation * (scale_from * of_source.point_m) + way.shift;
  Eigen::Vector2f pixel;
  if (!way.target.lens.project(point, pixel)) return std::nullopt;
  const int x = static_cast<int>(std::floor(pixel.x() / kInstantBlock));
  const int y = static_cast<int>(std::floor(pixel.y() / kInstantBlock));
  const Eigen::Vector3f normal = way.rotation * of_source.normal;
  const SurfacePoint* nearest = nullptr;
  float nearest_m = options.slide_per_reach * way.reach_m;
  for (int v = std::max(0, y - options.window);
       v <= std::min(surface.at.height() - 1, y + options.window); ++v) {
    for (int u = std::max(0, x - options.window);
         u <= std::min(surface.at.width() - 1, x + options.window); ++u) {
      const SurfacePoint& seen = surface.at.at(u, v);
      if (!(seen.normal.dot(normal) >= options.min_cosine)) continue;
      const float apart_m = (point - scale_to * seen.point_m).norm();
      if (apart_m >= nearest_m) continue;
      nearest_m = apart_m;
      nearest = &seen;
    }
  }
  if (!nearest) return std::nullopt;
  const Eigen::Vector3f mean = (nearest->normal + normal).normalized();
  const float residual_m = mean.dot(point - scale_to * nearest->point_m);
  if (!(std::abs(residual_m) <= way.reach_m)) return std::nullopt;
  return MovingPartner{nearest, mean, residual_m};
}

/// Calls visit(of_source, partner) for the points of the source that the target shows too.
template <class Visit>
std::size_t for_each_moving_partner(const MovingDirection& way, const MovingPartnerOptions& options,
                                    Visit visit) {
  std::size_t all = 0;
  for (const MovingSurface& surface : way.source.surfaces) all += surface.blocks.size();
  const std::size_t step = std::max<std::size_t>(1, all / options.points);
  std::size_t number = 0, instants = 0;
  for (const MovingSurface& from : way.source.surfaces) {
    const MovingSurface* const to =
        surface_at_time(way.target.surfaces, from.time_s, options.max_apart_s);
    if (!to) continue;
    bool any = false;
    for (const Eigen::Vector2i& block : from.blocks) {
      if (number++ % step != 0) continue;
      const SurfacePoint& of_source = from.at.at(block.x(), block.y());
      const auto partner = partner_of(of_source, way, *to, options);
      if (!partner) continue;
      visit(of_source, *partner);
      any = true;
    }
    instants += any;
  }
  return instants;
}

}  // namespace

MovingPartners moving_partners(const MovingSide& a, const MovingSide& b,
                               const RigidTransform& a_from_b, float reach_m,
                               const MovingPartnerOptions& options) {
  MovingPartners found;
  const auto variance_m2 = static_cast<float>(options.surface_sigma_m * options.surface_sigma_m);
  const Eigen::Matrix3f rotation = a_from_b.rotation.cast<float>();
  const std::size_t of_b = for_each_moving_partner(
      MovingDirection(b, a, a_from_b, reach_m), options,
      [&](const SurfacePoint& in_b, const MovingPartner& in_a) {
        found.partners.push_back(
            {in_a.seen->point_m, in_b.point_m, in_a.normal, in_a.residual_m, variance_m2});
      });
  const std::size_t of_a = for_each_moving_partner(
      MovingDirection(a, b, a_from_b.inverse(), reach_m), options,
      [&](const SurfacePoint& in_a, const MovingPartner& in_b) {
        found.partners.push_back({in_a.point_m, in_b.seen->point_m, rotation * in_b.normal,
                                  -in_b.residual_m, variance_m2});
      });
  found.instants = std::max(of_a, of_b);
  return found;
}

}  // namespace roomcast::alignment
