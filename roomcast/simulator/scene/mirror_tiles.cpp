// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;

/// Tiles fit the room exactly: the floor looks the same when it is shifted by a tile, mirrored, or
/// rotated by 180 degrees.
void add_tiled_shell(Room& room, float tile_m, Random& random) {
  constexpr std::array<std::array<std::uint32_t, 2>, 4> kTones = {
      {{0xe4e0d6, 0x3a4a5a}, {0xd8d4cc, 0x8a3a30}, {0xe8e6e0, 0x2f5f4a}, {0xd0d4d8, 0x5a4a3a}}};
  const auto& tones = random.one_of(kTones);
  ShellSurfaces shell{};
  Surface tiles = painted(Pattern::kTiles, tones[0], tones[1], 0x8a8880, random.seed(), 0.5F);
  tiles.size_m = Vector2f::Constant(tile_m);
  shell.floor = room.add(tiles);
  shell.ceiling = room.add(painted(Pattern::kFlat, 0xeceae6, 0, 0, random.seed(), 0.6F));
  shell.skirting = room.add(painted(Pattern::kFlat, 0xd8d6d0, 0, 0, random.seed()));
  shell.walls.fill(room.add(painted(Pattern::kFlat, 0xdcdcd6, 0, 0, random.seed(), 0.6F)));
  add_shell(room, shell);
}

/// Identical posters: three on each long wall, two on each short one.
void add_posters(Room& room, const Furnisher& furnisher, Random& random) {
  Surface poster = painted(Pattern::kPoster, 0xf0ece0, 0x2f4a6a, 0x202020, random.seed());
  const std::array<std::array<std::uint32_t, 2>, 3> tones = {
      {{0xb04030, 0x2a2a2a}, {0x3a7a8a, 0x1d3026}, {0xd0a040, 0x3a2a1a}}};
  poster.accent = linear_from_srgb(random.one_of(tones)[0]);
  poster.size_m = {0.56F, 0.80F};
  const float along = room.size_m.x() / 3.6F;
  for (const int wall : {2, 3}) {
    for (const float share : {-1.0F, 0.0F, 1.0F})
      add_picture(room, on_wall(room, wall, share * along, 1.62F), furnisher.palette().dark,
                  poster);
  }
  for (const int wall : {0, 1}) {
    for (const float share : {-0.5F, 0.5F})
      add_picture(room, on_wall(room, wall, share * along, 1.62F), furnisher.palette().dark,
                  poster);
  }
}

/// Two rows of identical chairs, backs to the long walls.
void add_rows_of_chairs(Room& room, FloorPlan& plan, const Furnisher& furnisher, int per_row) {
  const float pitch = 0.72F;
  const float from_wall = 0.5F * room.size_m.z() - 0.36F;
  for (int i = 0; i < per_row; ++i) {
    const float x = pitch * (static_cast<float>(i) - 0.5F * static_cast<float>(per_row - 1));
    for (const bool far_side : {false, true}) {
      const Affine3f at =
          standing_at(x, far_side ? from_wall : -from_wall, far_side ? 3.14159265F : 0);
      plan.take(at, {0.50F, 0.92F, 0.60F});
      add_shell_chair(room, at, furnisher.palette().cloth, furnisher.palette().metal);
    }
  }
}

}  // namespace

std::optional<Room> try_mirror_tiles(std::uint32_t seed) {
  Random random(seed);
  const float tile_m = random.chance(0.5F) ? 0.45F : 0.36F;
  const auto whole_tiles = [&](float size_m) { return tile_m * std::round(size_m / tile_m); };
  Room room = empty_room({whole_tiles(5.4F), 2.6F, whole_tiles(4.5F)}, {0.45F, 0.45F, 0.45F},
                         draw_sensor_mounts_in_corners, random);
  FloorPlan plan = plan_of(room, random);

  add_tiled_shell(room, tile_m, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  add_posters(room, furnisher, random);
  add_rows_of_chairs(room, plan, furnisher, 5);
  Person walker = draw_person(room, random);
  walker.stops = {Waypoint{}, Waypoint{}, Waypoint{}};
  for (std::size_t i = 0; i < walker.stops.size(); ++i) {
    const float angle = 2.1F * static_cast<float>(i);
    walker.stops[i].at_m = {1.3F * std::sin(angle), 0.75F * std::cos(angle)};
    walker.stops[i].heading_rad = angle + 1.6F;
  }
  room.people.push_back(walker);
  plan.keep_way({-1.3F, 0}, {1.3F, 0}, 1.15F);
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
