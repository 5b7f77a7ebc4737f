// SPDX-License-Identifier: Apache-2.0
// Rooms whose floor returns little of a depth camera's light: polished stone mirrors it away except
// next to a sensor, and black carpet swallows it.
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

/// add_shell adds the floor first.
Surface& floor_of(Room& room) {
  return room.surfaces[room.mesh.surface.front()];
}

}  // namespace

std::optional<Room> try_glossy_floor(std::uint32_t seed) {
  auto room = try_lab(seed);
  if (!room) return room;
  Surface& floor = floor_of(*room);
  floor.infrared = 0.12F;
  floor.gloss = 0.5F;
  floor.polish = 800.0F;
  return room;
}

std::optional<Room> try_dark_floor(std::uint32_t seed) {
  auto room = try_meeting(seed);
  if (!room) return room;
  Surface& floor = floor_of(*room);
  floor.infrared = 0.05F;
  for (Eigen::Vector3f* color : {&floor.base, &floor.accent, &floor.trim}) *color *= 0.15F;
  return room;
}

}  // namespace roomcast::simulator
