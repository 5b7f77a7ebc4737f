// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/start_pose.h"

#include <Eigen/Geometry>

namespace roomcast::hub {
namespace {

using Eigen::Vector3d;

constexpr double kEyeHeight_m = 1.6;
constexpr double kLookAtHeight_m = 1.0;
constexpr double kSubjectDistance_m = 2.5;  // typical of indoor depth sensors
constexpr double kElbowRoom_m = 0.6;
constexpr double kStepTowardsSubject =
    0.15;  // share of the distance: the viewer starts in front of the sensor, not inside it
constexpr double kSamePlace_m = 1e-6;

Vector3d at_height(const Vector3d& point_m, double height_m) {
  return {point_m.x(), height_m, point_m.z()};
}

/// The centre of the points that the sensors look at.
Vector3d subject(std::span<const RigidTransform> world_from_depth) {
  Vector3d sum_m = Vector3d::Zero();
  for (const RigidTransform& sensor : world_from_depth)
    sum_m += sensor * Vector3d(0, 0, kSubjectDistance_m);
  return sum_m / static_cast<double>(world_from_depth.size());
}

/// The pose of a viewer above or below `eye_m` who faces the vertical through `target_m`; straight
/// above it, one who looks along -z.
RigidTransform facing(const Vector3d& eye_m, const Vector3d& target_m) {
  const Vector3d eye = at_height(eye_m, kEyeHeight_m);
  Vector3d target = at_height(target_m, kLookAtHeight_m);
  if ((at_height(target, kEyeHeight_m) - eye).norm() < kSamePlace_m)
    target = eye - Vector3d::UnitZ();
  RigidTransform world_from_viewer = world_from_optical_looking_at(eye, target);
  world_from_viewer.rotation.rightCols<2>() *= -1;  // optical y is down, z forward
  return world_from_viewer;
}

}  // namespace

RigidTransform start_pose(std::span<const RigidTransform> world_from_depth, std::size_t index) {
  if (world_from_depth.empty()) {
    const Vector3d eye_m(kElbowRoom_m * static_cast<double>(index), 0, 0);
    return facing(eye_m, eye_m - Vector3d::UnitZ());
  }
  const Vector3d subject_m = subject(world_from_depth);
  const Vector3d sensor_m = world_from_depth[index % world_from_depth.size()].translation_m;
  const Vector3d towards_m = at_height(subject_m - sensor_m, 0);
  Vector3d eye_m = sensor_m + kStepTowardsSubject * towards_m;
  if (towards_m.norm() > kSamePlace_m) {
    const double aside_m = kElbowRoom_m * static_cast<double>(index / world_from_depth.size());
    eye_m += aside_m * towards_m.normalized().cross(Vector3d::UnitY());
  }
  return facing(eye_m, subject_m);
}

}  // namespace roomcast::hub
