// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_room.h"

#include <utility>

#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/scene/board_bearer.h"
#include "roomcast/simulator/scene/moved_cabinet.h"
#include "roomcast/simulator/scene/walkabout.h"

namespace roomcast::simulator {
namespace {

bool let_in(Visitor visitor, simulator::Room& room) {
  switch (visitor) {
    case Visitor::kWalkabout:
      return simulator::add_walkabout(room);
    case Visitor::kBoardBearer:
      return simulator::add_board_bearer(room);
    case Visitor::kNone:
      break;
  }
  return true;
}

}  // namespace

Result<std::shared_ptr<const SimulatedRoom>> SimulatedRoom::build(std::string_view scene,
                                                                  std::uint64_t seed,
                                                                  Visitor visitor,
                                                                  std::optional<int> cabinet) {
  auto room = simulator::build_room(scene, seed);
  if (!room) return std::move(room).error();
  if (!let_in(visitor, *room)) {
    return Error{
        ErrorCode::kInvalidArgument,
        "the scene \"" + room->name + "\" has no walking person whose way a visitor could take"};
  }
  if (cabinet && !simulator::add_cabinet(*room, *cabinet)) {
    return Error{ErrorCode::kInvalidArgument,
                 "the scene \"" + room->name + "\" has no space for a cabinet"};
  }
  std::shared_ptr<SimulatedRoom> built(new SimulatedRoom(*std::move(room)));
  auto rays = simulator::RayScene::build(built->room_.mesh);
  if (!rays) return std::move(rays).error();
  built->rays_ = *std::move(rays);
  built->texels_ = std::make_unique<simulator::SurfaceTexels>(
      built->room_, simulator::MovingThings(built->room_));
  return std::shared_ptr<const SimulatedRoom>(std::move(built));
}

}  // namespace roomcast::simulator
