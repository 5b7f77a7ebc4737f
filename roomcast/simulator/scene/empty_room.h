// SPDX-License-Identifier: Apache-2.0
// How every scene begins: a room of some size, with its sensors, and nothing in it. Metres.
#pragma once

#include "roomcast/simulator/random/dice.h"
#include "roomcast/simulator/scene/floor_plan.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/scene/stands.h"

namespace roomcast::sim {

using DrawStands = Stands(const Eigen::Vector3f& room_size_m, Dice& dice);

[[nodiscard]] inline Room empty_room(const Eigen::Vector3f& size_m, const Eigen::Vector3f& ambient,
                                     DrawStands& draw_stands, Dice& dice) {
  Room room;
  room.size_m = size_m;
  room.ambient = ambient;
  room.stands = draw_stands(size_m, dice);
  return room;
}

/// Of the empty room, what its sensors look across kept free.
[[nodiscard]] inline FloorPlan plan_of(const Room& room, Dice& dice) {
  FloorPlan plan(room.size_m, dice.seed());
  for (const SensorStand& stand : room.stands) plan.keep_view(stand);
  return plan;
}

}  // namespace roomcast::sim
