// SPDX-License-Identifier: Apache-2.0
// How far off a placed rig is, whose true poses are known: where its sensors put the middle of
// their room. What all sensors are off by alike is no error, for a rig may stand anywhere in the
// world. Metres in, millimetres and degrees out. Thread-safe (no state).
#pragma once

#include <span>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

/// Of the sensor that is off most.
struct RigError {
  double from_all_mm = 0, from_all_deg = 0;      // from the mean of all sensors
  double from_first_mm = 0, from_first_deg = 0;  // from the first sensor
};

/// `truth` and `found` are world_from_sensor, each in a world of its own; as many of both.
/// `middle_m` is the room's, in the world of the truth.
[[nodiscard]] RigError rig_error(std::span<const RigidTransform> truth,
                                 std::span<const RigidTransform> found,
                                 const Eigen::Vector3d& middle_m);

}  // namespace roomcast::bench
