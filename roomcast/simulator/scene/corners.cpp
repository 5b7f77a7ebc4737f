// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/scenes.h"
#include "roomcast/simulator/scene/strolls.h"

namespace roomcast::sim {

std::optional<Room> try_corners(std::uint32_t seed) {
  Dice dice(seed);
  Room room = empty_room({5.0F, 2.5F, 4.2F}, {0.52F, 0.50F, 0.48F}, draw_stands_in_corners, dice);
  FloorPlan plan = plan_of(room, dice);

  add_homely_shell(room, dice.chance(0.6F) ? FloorKind::kBoards : FloorKind::kCarpet, dice);
  Furnisher furnisher(room, plan, dice);
  furnisher.pendant();
  furnisher.door();
  furnisher.window();
  Stroll stroll(room, plan, dice);
  const auto sofa = furnisher.sofa(1.0F);
  const auto shelf = furnisher.bookshelf(0.8F);
  if (!sofa || !shelf) return std::nullopt;
  if (!stroll.to_sit(seat_of_sofa(*sofa, dice.between(-0.35F, 0.35F))) ||
      !stroll.to_reach(*shelf, {dice.between(-0.2F, 0.2F), dice.between(0.9F, 1.3F), 0.16F}))
    return std::nullopt;
  room.people.push_back(stroll.walker());

  if (dice.chance(0.5F)) {
    furnisher.desk(false);
    furnisher.armchair();
  } else {
    furnisher.dining_table();
    furnisher.sideboard();
  }
  if (dice.chance(0.6F)) {
    if (auto other = stroll.bystander()) room.people.push_back(*std::move(other));
  }
  furnisher.floor_lamp();
  furnisher.plant();
  if (dice.chance(0.5F)) furnisher.plant();
  furnisher.pictures(4 + dice.below(4));
  furnisher.clock();
  furnisher.odds_and_ends(3 + dice.below(3));
  furnisher.rug_under(stroll.plaza(), {dice.between(1.4F, 2.0F), dice.between(1.8F, 2.4F)});
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::sim
