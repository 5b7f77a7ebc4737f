// SPDX-License-Identifier: Apache-2.0
// Pose error of a rig with known poses, measured at the middle of the room. A common offset of all
// sensors is not an error, because a rig may be anywhere in the world. Metres in, millimetres and
// degrees out. Thread-safe (no state).
#pragma once

#include <span>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

/// Errors of the sensor with the largest error.
struct RigError {
  double from_all_mm = 0, from_all_deg = 0;      // relative to the mean of all sensors
  double from_first_mm = 0, from_first_deg = 0;  // relative to the first sensor
};

/// `truth` and `found` are world_from_sensor, each in a world of its own, and have the same length.
/// `middle_m` is the middle of the room in the world of the truth.
[[nodiscard]] RigError rig_error(std::span<const RigidTransform> truth,
                                 std::span<const RigidTransform> found,
                                 const Eigen::Vector3d& middle_m);

}  // namespace roomcast::bench
