// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/scenes.h"
#include "roomcast/simulator/scene/strolls.h"

namespace roomcast::sim {

std::optional<Room> try_office(std::uint32_t seed) {
  Dice dice(seed);
  Room room = empty_room({dice.between(5.8F, 6.4F), 2.7F, dice.between(4.9F, 5.4F)},
                         {0.44F, 0.44F, 0.44F}, draw_stands_around, dice);
  FloorPlan plan = plan_of(room, dice);

  add_plain_shell(room, FloorKind::kCarpet, dice);
  Furnisher furnisher(room, plan, dice);
  furnisher.panels();
  furnisher.door();
  Stroll stroll(room, plan, dice);
  const auto desk = furnisher.desk(true);
  const auto shelf = furnisher.bookshelf(0.8F);
  const auto board = furnisher.whiteboard(0.36F);
  if (!desk || !shelf || !board) return std::nullopt;
  if (!stroll.to_reach(*shelf, {dice.between(-0.2F, 0.2F), dice.between(0.85F, 1.3F), 0.16F}) ||
      !stroll.to_reach(*board, {dice.between(-0.3F, 0.3F), -0.15F, 0.03F}, Deed::kWrite, 6.0F))
    return std::nullopt;
  room.people.push_back(stroll.walker());
  Person typist = draw_person(room, dice);
  typist.stops = {typing_at(*desk)};
  room.people.push_back(typist);

  furnisher.desk(false);
  furnisher.desk(false);
  furnisher.window();
  if (dice.chance(0.4F)) furnisher.window();
  furnisher.cabinet();
  furnisher.sideboard();
  furnisher.plant();
  furnisher.plant();
  furnisher.pictures(5 + dice.below(4));
  furnisher.clock();
  furnisher.bookshelf();
  furnisher.odds_and_ends(3 + dice.below(3));
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::sim
