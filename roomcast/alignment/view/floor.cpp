// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/floor.h"

namespace roomcast::alignment {
namespace {

bool faces_up(const Plane& plane, const std::optional<Eigen::Vector3d>& up,
              const FloorOptions& options) {
  if (up) return plane.normal.dot(up->cast<float>()) > options.min_cosine_by_gravity;
  return -plane.normal.y() > options.min_cosine_by_picture;
}

bool has_nothing_below(const Plane& plane, std::span<const SurfacePoint> samples,
                       const FloorOptions& options) {
  std::size_t below = 0;
  for (const SurfacePoint& sample : samples)
    below += plane.height_m(sample.point_m) < -options.below_m;
  return static_cast<float>(below) < options.max_below_share * static_cast<float>(samples.size());
}

}  // namespace

std::optional<Plane> find_floor(std::span<const Plane> planes,
                                std::span<const SurfacePoint> samples,
                                const std::optional<Eigen::Vector3d>& up,
                                const FloorOptions& options) {
  const Plane* largest = nullptr;
  for (const Plane& plane : planes) {
    if (!faces_up(plane, up, options) || plane.offset_m < options.min_height_m) continue;
    if (!has_nothing_below(plane, samples, options)) continue;
    if (!largest || plane.points_m.size() > largest->points_m.size()) largest = &plane;
  }
  if (!largest) return std::nullopt;
  return Plane{largest->normal, largest->offset_m, {}};
}

}  // namespace roomcast::alignment
