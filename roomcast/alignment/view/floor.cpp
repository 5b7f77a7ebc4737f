// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/floor.h"

namespace roomcast::alignment {
namespace {

constexpr float kBelow_m = -0.08F;
constexpr float kMaxBelow = 0.03F;         // share of the samples
constexpr float kUprightByPicture = 0.5F;  // cosine: a camera may look down by 60 degrees
constexpr float kUprightByGravity = 0.97F;
constexpr float kMinHeight_m = 0.3F;  // of the camera above its floor

bool faces_up(const Plane& plane, const std::optional<Eigen::Vector3d>& up) {
  if (up) return plane.normal.dot(up->cast<float>()) > kUprightByGravity;
  return -plane.normal.y() > kUprightByPicture;
}

bool has_nothing_below(const Plane& plane, std::span<const SurfacePoint> samples) {
  std::size_t below = 0;
  for (const SurfacePoint& sample : samples) below += plane.height_m(sample.point_m) < kBelow_m;
  return static_cast<float>(below) < kMaxBelow * static_cast<float>(samples.size());
}

}  // namespace

std::optional<Plane> find_floor(std::span<const Plane> planes,
                                std::span<const SurfacePoint> samples,
                                const std::optional<Eigen::Vector3d>& up) {
  const Plane* largest = nullptr;
  for (const Plane& plane : planes) {
    if (!faces_up(plane, up) || plane.offset_m < kMinHeight_m) continue;
    if (!has_nothing_below(plane, samples)) continue;
    if (!largest || plane.points_m.size() > largest->points_m.size()) largest = &plane;
  }
  if (!largest) return std::nullopt;
  return Plane{largest->normal, largest->offset_m, {}};
}

}  // namespace roomcast::alignment
