// SPDX-License-Identifier: Apache-2.0
// Sends a person's prior for a sensor's pose to the hub's aligner, and waits for the answer.
// Metres, radians. Threading: thread-safe (no state); blocks.
#pragma once

#include <chrono>
#include <string>

#include <Eigen/Core>

#include "roomcast/client/credential.h"
#include "roomcast/client/room_requests.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::client {

struct NudgeOptions {
  std::string hub_url;
  std::string room;            // empty: the hub's only room
  Credential credential = {};  // an admin's
  std::string sensor;
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // along the world's axes, y up
  double turn_rad = 0;  // counter-clockwise from above, about the sensor's position
  double tilt_rad = 0;  // about the sensor's own horizontal axis, upwards
  std::chrono::milliseconds patience = std::chrono::seconds(20);
};

/// The new pose of the sensor. kUnavailable: the sensor has supplied its own pose, or the aligner
/// rejected the prior, with the reason, or no answer came. kNotFound: there is no such sensor. Else
/// the reason why there is no connection.
[[nodiscard]] Result<PlacedSensor> nudge_sensor(const NudgeOptions& options);

/// kInvalidArgument: a number is not finite.
[[nodiscard]] Status check_nudge(const NudgeOptions& options);

/// Tilts and turns the sensor about its own position, then shifts it.
[[nodiscard]] RigidTransform nudged(const RigidTransform& world_from_depth,
                                    const NudgeOptions& options);

}  // namespace roomcast::client
