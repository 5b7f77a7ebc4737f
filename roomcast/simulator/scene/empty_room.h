// SPDX-License-Identifier: Apache-2.0
// Starts a scene: a room of given size with its sensors and nothing else. Metres.
#pragma once

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/floor_plan.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/scene/sensor_mounts.h"

namespace roomcast::simulator {

using DrawStands = Stands(const Eigen::Vector3f& room_size_m, Random& random);

[[nodiscard]] inline Room empty_room(const Eigen::Vector3f& size_m, const Eigen::Vector3f& ambient,
                                     DrawStands& draw_sensor_mounts, Random& random) {
  Room room;
  room.size_m = size_m;
  room.ambient = ambient;
  room.sensor_mounts = draw_sensor_mounts(size_m, random);
  return room;
}

/// Floor plan of the empty room, with the sensors' views kept free.
[[nodiscard]] inline FloorPlan plan_of(const Room& room, Random& random) {
  FloorPlan plan(room.size_m, random.seed());
  for (const SensorMount& mount : room.sensor_mounts) plan.keep_view(mount);
  return plan;
}

}  // namespace roomcast::simulator
