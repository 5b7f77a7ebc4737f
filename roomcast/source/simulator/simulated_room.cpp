// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_room.h"

#include <utility>

#include "roomcast/source/simulator/people/moving_things.h"
#include "roomcast/source/simulator/scene/board_bearer.h"

namespace roomcast {

Result<std::shared_ptr<const SimulatedRoom>> SimulatedRoom::build(std::string_view scene,
                                                                  std::uint64_t seed, bool board) {
  auto room = sim::build_room(scene, seed);
  if (!room) return std::move(room).error();
  if (board && !sim::add_board_bearer(*room)) {
    return Error{ErrorCode::kInvalidArgument,
                 "in the scene \"" + room->name + "\" nobody walks about who could carry a board"};
  }
  std::shared_ptr<SimulatedRoom> built(new SimulatedRoom(*std::move(room)));
  auto rays = sim::RayScene::build(built->room_.mesh);
  if (!rays) return std::move(rays).error();
  built->rays_ = *std::move(rays);
  built->texels_ =
      std::make_unique<sim::SurfaceTexels>(built->room_, sim::MovingThings(built->room_));
  return std::shared_ptr<const SimulatedRoom>(std::move(built));
}

}  // namespace roomcast
