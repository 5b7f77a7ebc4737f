// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {

std::optional<Room> try_livingroom(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.6F, 6.2F), 2.6F, random.between(4.8F, 5.2F)},
                         {0.52F, 0.50F, 0.48F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);

  add_homely_shell(room, FloorKind::kBoards, random);
  Furnisher furnisher(room, plan, random);
  furnisher.pendant();
  furnisher.window();
  furnisher.door();
  Route route(room, plan, random);
  const auto sofa = furnisher.sofa(0.9F);
  const auto shelf = furnisher.bookshelf(0.8F);
  if (!sofa || !shelf) return std::nullopt;
  const float along = random.chance(0.5F) ? 0.38F : -0.38F;
  if (!route.to_sit(seat_of_sofa(*sofa, along)) ||
      !route.to_reach(*shelf, {random.between(-0.2F, 0.2F), random.between(0.85F, 1.3F), 0.16F}))
    return std::nullopt;
  room.people.push_back(route.walker());

  const auto table = furnisher.coffee_table_before(*sofa);
  const bool dines = furnisher.dining_table().has_value();
  furnisher.television();
  if (!dines) furnisher.armchair();
  furnisher.sideboard();
  furnisher.floor_lamp();
  furnisher.plant();
  furnisher.bookshelf();
  furnisher.pictures(5 + random.below(4));
  furnisher.clock();
  if (random.chance(0.5F)) furnisher.plant();
  furnisher.odds_and_ends(2 + random.below(4));
  const Eigen::Vector3f before = *sofa * Eigen::Vector3f(0, 0, 1.3F);
  furnisher.rug_under(table ? Eigen::Vector2f(before.x(), before.z()) : route.plaza(),
                      {random.between(1.7F, 2.2F), random.between(2.0F, 2.5F)});
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
