// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/nudge.h"

#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/client/room_requests.h"
#include "roomcast/client/subscriber.h"

namespace roomcast::client {

Status check_nudge(const NudgeOptions& options) {
  if (options.shift_m.allFinite() && std::isfinite(options.turn_rad) &&
      std::isfinite(options.tilt_rad))
    return {};
  return invalid_argument("a number of the nudge is not finite");
}

RigidTransform nudged(const RigidTransform& world_from_depth, const NudgeOptions& options) {
  const Eigen::AngleAxisd turn(options.turn_rad, Eigen::Vector3d::UnitY());  // world axis
  const Eigen::AngleAxisd tilt(options.tilt_rad, Eigen::Vector3d::UnitX());  // sensor axis
  return {turn * world_from_depth.rotation * tilt,
          world_from_depth.translation_m + options.shift_m};
}

Result<PlacedSensor> nudge_sensor(const NudgeOptions& options) {
  auto room = Subscriber::open({.hub_url = options.hub_url,
                                .room = options.room,
                                .credential = options.credential,
                                .name = {},
                                .log = {}});
  if (!room) return room.error();
  const auto wanted = [&](const RigidTransform& pose) { return nudged(pose, options); };
  return place_sensor(**room, options.sensor, wanted, {.time = options.patience});
}

}  // namespace roomcast::client
