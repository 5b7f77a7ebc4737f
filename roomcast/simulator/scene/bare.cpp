// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

/// One paint for all walls and the ceiling, one uniform surface for the floor.
void add_empty_shell(Room& room, Random& random) {
  constexpr std::array<std::uint32_t, 4> kPaints = {0xdedcd6, 0xd2d6d8, 0xe2d9c8, 0xcdd2c8};
  constexpr std::array<std::uint32_t, 4> kFloors = {0x8a8d90, 0x9a8c78, 0x74808a, 0xb0aca4};
  ShellSurfaces shell{};
  shell.floor =
      room.add(painted(Pattern::kFlat, random.one_of(kFloors), 0, 0, random.seed(), 0.45F));
  shell.ceiling = room.add(painted(Pattern::kFlat, 0xeceae6, 0, 0, random.seed(), 0.6F));
  shell.skirting = room.add(painted(Pattern::kFlat, 0xf0eee8, 0, 0, random.seed()));
  shell.walls.fill(
      room.add(painted(Pattern::kFlat, random.one_of(kPaints), 0, 0, random.seed(), 0.6F)));
  add_shell(room, shell);
}

}  // namespace

std::optional<Room> try_bare(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(4.6F, 5.6F), 2.6F, random.between(4.0F, 4.8F)},
                         {0.45F, 0.45F, 0.45F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);

  add_empty_shell(room, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  furnisher.door();
  Route route(room, plan, random);
  const auto table = plan.against_wall({1.4F, 0.75F, 0.7F}, 0.8F);
  const auto cabinet = plan.against_wall({0.9F, 1.2F, 0.45F}, 0.8F);
  if (!table || !cabinet) return std::nullopt;
  const auto white = room.add(painted(Pattern::kFlat, 0xe4e2dc, 0, 0, random.seed()));
  add_table(room, *table, white, {1.4F, 0.73F, 0.7F});
  add_sideboard(room, *cabinet, white, furnisher.palette().metal, {0.9F, 1.2F, 0.45F});
  if (!route.to_reach(*table, {random.between(-0.4F, 0.4F), 0.80F, 0.20F}) ||
      !route.to_reach(*cabinet, {0.0F, 0.95F, 0.25F}))
    return std::nullopt;
  room.people.push_back(route.walker());
  for (int i = random.below(3); i >= 0; --i) {
    if (const auto at = plan.in_the_open({0.5F, 0.95F, 0.5F}))
      add_shell_chair(room, *at, white, furnisher.palette().metal);
  }
  if (random.chance(0.4F)) {
    if (auto other = route.bystander()) room.people.push_back(*std::move(other));
  }
  if (random.chance(0.3F)) furnisher.pictures(1);
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
