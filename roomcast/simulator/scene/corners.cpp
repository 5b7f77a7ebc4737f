// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {

std::optional<Room> try_corners(std::uint32_t seed) {
  Random random(seed);
  Room room =
      empty_room({5.0F, 2.5F, 4.2F}, {0.52F, 0.50F, 0.48F}, draw_sensor_mounts_in_corners, random);
  FloorPlan plan = plan_of(room, random);

  add_homely_shell(room, random.chance(0.6F) ? FloorKind::kBoards : FloorKind::kCarpet, random);
  Furnisher furnisher(room, plan, random);
  furnisher.pendant();
  furnisher.door();
  furnisher.window();
  Route route(room, plan, random);
  const auto sofa = furnisher.sofa(1.0F);
  const auto shelf = furnisher.bookshelf(0.8F);
  if (!sofa || !shelf) return std::nullopt;
  if (!route.to_sit(seat_of_sofa(*sofa, random.between(-0.35F, 0.35F))) ||
      !route.to_reach(*shelf, {random.between(-0.2F, 0.2F), random.between(0.9F, 1.3F), 0.16F}))
    return std::nullopt;
  room.people.push_back(route.walker());

  if (random.chance(0.5F)) {
    furnisher.desk(false);
    furnisher.armchair();
  } else {
    furnisher.dining_table();
    furnisher.sideboard();
  }
  if (random.chance(0.6F)) {
    if (auto other = route.bystander()) room.people.push_back(*std::move(other));
  }
  furnisher.floor_lamp();
  furnisher.plant();
  if (random.chance(0.5F)) furnisher.plant();
  furnisher.pictures(4 + random.below(4));
  furnisher.clock();
  furnisher.odds_and_ends(3 + random.below(3));
  furnisher.rug_under(route.plaza(), {random.between(1.4F, 2.0F), random.between(1.8F, 2.4F)});
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
