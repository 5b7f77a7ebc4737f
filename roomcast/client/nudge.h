// SPDX-License-Identifier: Apache-2.0
// Tells a hub's aligner a person's guess where a sensor stands, and waits for what it makes of it.
// Metres, radians. Threading: thread-safe (no state); blocks.
#pragma once

#include <chrono>
#include <string>

#include <Eigen/Core>

#include "roomcast/client/credential.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::client {

struct NudgeOptions {
  std::string hub_url;
  std::string room;            // empty: the hub's only one
  Credential credential = {};  // an admin's
  std::string sensor;
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // along the world's axes, y up
  double turn_rad = 0;  // about the vertical, counter-clockwise from above, where it stands
  double tilt_rad = 0;  // about its own horizontal axis, upwards
  std::chrono::milliseconds patience = std::chrono::seconds(20);
};

struct NudgedSensor {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;
};

/// Where the sensor stands from now on. kUnavailable: why the aligner did not take the guess, or
/// that nobody answered. kNotFound: there is no such sensor. Else why there is no connection.
[[nodiscard]] Result<NudgedSensor> nudge_sensor(const NudgeOptions& options);

/// It is tilted and turns where it stands, then it is shifted.
[[nodiscard]] RigidTransform nudged(const RigidTransform& world_from_depth,
                                    const NudgeOptions& options);

}  // namespace roomcast::client
