// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/world_frame.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

bool agree(const Plane& one, const Plane& other, const WorldFrameOptions& options) {
  return one.normal.dot(other.normal) > options.agree_cosine &&
         std::abs(one.offset_m - other.offset_m) < options.agree_height_m;
}

/// The largest set of floors that agree: a table mistaken for a floor is outvoted.
std::vector<Plane> largest_agreement(std::span<const Plane> floors,
                                     const WorldFrameOptions& options) {
  std::vector<Plane> best;
  for (const Plane& candidate : floors) {
    std::vector<Plane> with;
    std::copy_if(floors.begin(), floors.end(), std::back_inserter(with),
                 [&](const Plane& other) { return agree(candidate, other, options); });
    const bool lower = !best.empty() && candidate.offset_m > best.front().offset_m;
    if (with.size() > best.size() || (with.size() == best.size() && lower)) best = with;
  }
  return best;
}

Plane mean_plane(std::span<const Plane> planes) {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  std::vector<float> offsets;
  for (const Plane& plane : planes) {
    normal += plane.normal;
    offsets.push_back(plane.offset_m);
  }
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return {normal.normalized(), *middle, {}};
}

/// Rotation with world y along `up` and the sensor's horizontal viewing direction along world -z.
Eigen::Matrix3d world_from_origin_rotation(const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d flat = forward - up.dot(forward) * up;
  if (flat.norm() < 1e-3) flat = -Eigen::Vector3d::UnitY() + up.y() * up;  // looks straight down
  const Eigen::Vector3d back = -flat.normalized();
  Eigen::Matrix3d rotation;
  rotation << up.cross(back).transpose(), up.transpose(), back.transpose();
  return rotation;
}

}  // namespace

Plane transformed(const RigidTransform& a_from_b, const Plane& plane) {
  const Eigen::Vector3d normal = a_from_b.rotation * plane.normal.cast<double>();
  const double offset = double(plane.offset_m) - normal.dot(a_from_b.translation_m);
  return {normal.cast<float>(), static_cast<float>(offset), {}};
}

WorldFrame world_frame(std::span<const Plane> floors_in_origin, const WorldFrameOptions& options) {
  WorldFrame frame;
  const std::vector<Plane> floors = largest_agreement(floors_in_origin, options);
  if (floors.empty()) {
    frame.world_from_origin.rotation = world_from_origin_rotation(-Eigen::Vector3d::UnitY());
    return frame;
  }
  const Plane floor = mean_plane(floors);
  frame.has_floor = true;
  frame.world_from_origin.rotation =
      world_from_origin_rotation(floor.normal.cast<double>().normalized());
  frame.world_from_origin.translation_m = {0, double(floor.offset_m), 0};
  return frame;
}

}  // namespace roomcast::alignment
