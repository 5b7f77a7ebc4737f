// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {

std::optional<Room> try_office(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.4F), 2.7F, random.between(4.9F, 5.4F)},
                         {0.44F, 0.44F, 0.44F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);

  add_plain_shell(room, FloorKind::kCarpet, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  furnisher.door();
  Route route(room, plan, random);
  const auto desk = furnisher.desk(true);
  const auto shelf = furnisher.bookshelf(0.8F);
  const auto board = furnisher.whiteboard(0.36F);
  if (!desk || !shelf || !board) return std::nullopt;
  if (!route.to_reach(*shelf, {random.between(-0.2F, 0.2F), random.between(0.85F, 1.3F), 0.16F}) ||
      !route.to_reach(*board, {random.between(-0.3F, 0.3F), -0.15F, 0.03F}, Activity::kWrite, 6.0F))
    return std::nullopt;
  room.people.push_back(route.walker());
  Person typist = draw_person(room, random);
  typist.stops = {typing_at(*desk)};
  room.people.push_back(typist);

  furnisher.desk(false);
  furnisher.desk(false);
  furnisher.window();
  if (random.chance(0.4F)) furnisher.window();
  furnisher.cabinet();
  furnisher.sideboard();
  furnisher.plant();
  furnisher.plant();
  furnisher.pictures(5 + random.below(4));
  furnisher.clock();
  furnisher.bookshelf();
  furnisher.odds_and_ends(3 + random.below(3));
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
