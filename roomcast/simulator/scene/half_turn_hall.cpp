// SPDX-License-Identifier: Apache-2.0
// A hall that looks alike after half a turn: every piece stands there twice, opposite to itself,
// and so do the walls. Up to three pieces have no counterpart.
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector3f;

constexpr float kHalfTurn = 3.14159265F;

Affine3f opposite(const Affine3f& at) {
  return Eigen::AngleAxisf(kHalfTurn, Vector3f::UnitY()) * at;
}

/// Takes a random place and the opposite one; calls `add` for both, or for none.
template <class Add>
void add_twice(FloorPlan& plan, const Room& room, Random& random, const Vector3f& size_m,
               const Add& add) {
  for (int i = 0; i < 40; ++i) {
    const float x = random.between(-0.5F, 0.5F) * (room.size_m.x() - size_m.x() - 0.2F);
    const float z = random.between(-0.5F, 0.5F) * (room.size_m.z() - size_m.z() - 0.2F);
    const Affine3f here = standing_at(x, z, 0.5F * kHalfTurn * static_cast<float>(random.below(4)));
    const Affine3f there = opposite(here);
    if (overlap(footprint_of(here, size_m), footprint_of(there, size_m), 0.1F)) continue;
    if (!plan.is_free(footprint_of(here, size_m)) || !plan.is_free(footprint_of(there, size_m)))
      continue;
    if (!plan.take(here, size_m) || !plan.take(there, size_m)) continue;
    add(here);
    add(there);
    return;
  }
}

void add_even_shell(Room& room, Random& random) {
  constexpr std::array<std::uint32_t, 4> kPaints = {0xd8d2c4, 0xc8d2d0, 0xe0d8c0, 0xc9cfdc};
  ShellSurfaces shell{};
  const float tile_m = 0.4F;
  Surface floor = painted(Pattern::kTiles, 0xb8b2a6, 0x8d8678, 0x6a655c, random.seed(), 0.45F);
  floor.size_m = Eigen::Vector2f::Constant(tile_m);
  shell.floor = room.add(floor);
  shell.ceiling = room.add(painted(Pattern::kFlat, 0xeceae6, 0, 0, random.seed(), 0.6F));
  shell.skirting = room.add(painted(Pattern::kFlat, 0x77736c, 0, 0, random.seed()));
  const auto ends =
      room.add(painted(Pattern::kFlat, random.one_of(kPaints), 0, 0, random.seed(), 0.6F));
  const auto sides =
      room.add(painted(Pattern::kFlat, random.one_of(kPaints), 0, 0, random.seed(), 0.6F));
  shell.walls = {ends, ends, sides, sides};
  add_shell(room, shell);
}

/// The same picture on opposite walls.
void hang_pictures_twice(Room& room, const Furnisher& furnisher, Random& random) {
  for (const int wall : {0, 2}) {
    Surface picture = painted(Pattern::kPainting, 0x9a6a4a, 0x3a5a7a, 0xd8c090, random.seed());
    picture.size_m = {random.between(0.5F, 0.9F), random.between(0.4F, 0.7F)};
    const float along = random.between(-0.25F, 0.25F) * room.size_m.z();
    const float height = random.between(1.5F, 1.8F);
    add_picture(room, on_wall(room, wall, along, height), furnisher.palette().dark, picture);
    add_picture(room, on_wall(room, wall + 1, -along, height), furnisher.palette().dark, picture);
  }
}

void add_wanderer(Room& room, FloorPlan& plan, Random& random) {
  Person walker = draw_person(room, random);
  walker.stops = {Waypoint{}, Waypoint{}};
  walker.stops[0].at_m = {-1.2F, 0};
  walker.stops[1].at_m = {1.2F, 0};
  room.people.push_back(walker);
  plan.keep_way(walker.stops[0].at_m, walker.stops[1].at_m, 0.55F);
}

}  // namespace

std::optional<Room> try_half_turn_hall(std::uint32_t seed) {
  Random random(seed);
  const auto whole_tiles = [](float size_m) { return 0.4F * std::round(size_m / 0.4F); };
  Room room = empty_room(
      {whole_tiles(random.between(5.8F, 6.8F)), 3.0F, whole_tiles(random.between(4.8F, 5.6F))},
      {0.45F, 0.45F, 0.45F}, draw_sensor_mounts_in_corners, random);
  FloorPlan plan = plan_of(room, random);
  add_even_shell(room, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  add_wanderer(room, plan, random);
  const Palette& palette = furnisher.palette();
  const std::uint32_t books = random.seed();
  const Vector3f shelf(0.9F, random.between(1.1F, 1.4F), 0.34F);
  add_twice(plan, room, random, shelf,
            [&](const Affine3f& at) { add_bookshelf(room, at, palette.wood, shelf, books); });
  for (int i = 2 + random.below(2); i > 0; --i) {
    const Vector3f table(random.between(1.0F, 1.5F), 0.74F, 0.7F);
    add_twice(plan, room, random, table,
              [&](const Affine3f& at) { add_table(room, at, palette.dark_wood, table); });
  }
  for (int i = 3 + random.below(3); i > 0; --i) {
    add_twice(plan, room, random, {0.5F, 0.92F, 0.55F},
              [&](const Affine3f& at) { add_shell_chair(room, at, palette.cloth, palette.metal); });
  }
  hang_pictures_twice(room, furnisher, random);
  room.unique_things = random.below(4);
  for (int i = 0; i < room.unique_things; ++i) {
    if (i == 0) furnisher.plant();
    if (i == 1) furnisher.cabinet();
    if (i == 2) furnisher.odds_and_ends(1);
  }
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
