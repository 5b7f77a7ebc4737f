// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/scene/office.h"

#include <array>

#include "roomcast/source/simulator/scene/furniture.h"
#include "roomcast/source/simulator/scene/value_noise.h"

namespace roomcast::sim {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

void add_walls(Room& room, std::uint32_t seed) {
  ShellSurfaces shell{};
  shell.floor = room.add(painted(Pattern::kCarpetTiles, 0x4a5560, 0x6d7780, 0, seed, 0.4F));
  shell.ceiling = room.add(painted(Pattern::kPlaster, 0xe6e6e4, 0, 0, seed + 1U, 0.6F));
  shell.skirting = room.add(painted(Pattern::kPlain, 0x55585c, 0, 0, seed + 2U));
  const auto grey = room.add(painted(Pattern::kPlaster, 0xd3d6d6, 0, 0, seed + 3U, 0.6F));
  const auto green = room.add(painted(Pattern::kPlaster, 0x8fae9a, 0, 0, seed + 4U, 0.6F));
  const auto timber = room.add(painted(Pattern::kPlanks, 0xc9a877, 0xa98554, 0x5a452a, seed + 5U));
  shell.walls = {timber, grey, green, grey};
  add_shell(room, shell);
}

void add_desk(Room& room, const Affine3f& at, SurfaceIndex top, SurfaceIndex dark,
              std::uint32_t seed) {
  add_table(room, at, top, {1.50F, 0.73F, 0.75F});
  add_sideboard(room, at * Eigen::Translation3f(0.45F, 0, -0.05F), dark, dark,
                {0.42F, 0.60F, 0.55F});
  const Affine3f on_top = at * Eigen::Translation3f(0, 0.73F, 0);
  Surface shown = painted(Pattern::kScreen, 0xe8ecf0, 0x2a4a6a, 0x1c2430, seed, 0.04F);
  shown.size_m = {0.54F, 0.31F};
  shown.glow = 0.7F;
  add_monitor(room, on_top * Eigen::Translation3f(-0.12F, 0, -0.20F), dark, shown);
  add_box(room.mesh, dark, on_top, {-0.34F, 0, 0.06F}, {0.10F, 0.022F, 0.20F});
  const auto paper = room.add(painted(Pattern::kDrawings, 0xf2f0ea, 0x303848, 0x8c2f2b, seed + 1U));
  add_box(room.mesh, paper, on_top, {0.28F, 0, 0.0F}, {0.50F, 0.012F, 0.29F});
  const std::array<Vector2f, 4> mug = {
      Vector2f(0, 0), {0.04F, 0}, {0.042F, 0.095F}, {0.036F, 0.095F}};
  add_turned(room.mesh, room.add(painted(Pattern::kPlain, 0xd07a2a, 0, 0, seed + 2U)),
             on_top * Eigen::Translation3f(-0.55F, 0, 0.12F), mug);
}

void add_desks(Room& room, std::uint32_t seed) {
  const auto beech = room.add(painted(Pattern::kWood, 0xd8b98a, 0xbf9a66, 0, seed + 10U));
  const auto dark = room.add(painted(Pattern::kPlain, 0x2c2e33, 0, 0, seed + 11U, 0.15F));
  const auto blue = room.add(painted(Pattern::kFabric, 0x2f4f86, 0x4a6fae, 0, seed + 12U));
  const auto red = room.add(painted(Pattern::kFabric, 0x8c3a34, 0xae5a4e, 0, seed + 13U));
  add_desk(room, standing_at(-2.50F, -0.95F, 1.5708F), beech, dark, seed + 14U);
  add_desk(room, standing_at(-2.50F, 0.85F, 1.5708F), beech, dark, seed + 17U);
  add_desk(room, standing_at(1.15F, 1.98F, 3.1416F), beech, dark, seed + 20U);
  add_office_chair(room, standing_at(-1.75F, -0.85F, -1.2F), blue, dark);
  add_office_chair(room, standing_at(-1.70F, 0.95F, -1.9F), red, dark);
  add_office_chair(room, standing_at(1.30F, 1.30F, 0.4F), blue, dark);
}

void add_walls_things(Room& room, std::uint32_t seed) {
  const auto metal = room.add(painted(Pattern::kPlain, 0xb9bcc0, 0, 0, seed + 30U));
  const auto white = room.add(painted(Pattern::kPlain, 0xeeeeea, 0, 0, seed + 31U));
  const auto dark = room.add(painted(Pattern::kPlain, 0x2c2e33, 0, 0, seed + 32U, 0.15F));
  Surface board = painted(Pattern::kDrawings, 0xf4f5f4, 0x1f3f8c, 0xa03030, seed + 33U, 0.6F);
  board.size_m = {1.80F, 1.10F};
  add_picture(room, on_wall(room, 2, -0.85F, 1.50F), metal, board);
  Surface map = painted(Pattern::kPainting, 0x3d7a6a, 0x1f3a4a, 0x202020, 2U * seed);
  map.size_m = {0.85F, 0.60F};
  add_picture(room, on_wall(room, 3, -1.40F, 1.60F), dark, map);
  map.seed = 2U * seed + 1U;
  add_picture(room, on_wall(room, 0, 0.0F, 1.65F), dark, map);
  Surface view = painted(Pattern::kGarden, 0x3a5a36, 0x8fa868, 0, seed + 34U, 0.0F);
  view.size_m = {1.70F, 1.20F};
  view.glow = 1.0F;
  const auto blind = room.add(painted(Pattern::kFabric, 0xa8b4bc, 0xc6ced2, 0, seed + 35U));
  add_window(room, on_wall(room, 1, 0.35F, 1.60F), white, view, blind);
  add_radiator(room, on_wall(room, 1, 0.35F, 0.0F), white, 1.3F);
  add_door(room, on_wall(room, 2, 1.95F, 0.0F),
           room.add(painted(Pattern::kWood, 0xa87a4a, 0x825a30, 0, seed + 36U)), metal);
  add_clock(room, on_wall(room, 2, 0.75F, 1.95F), dark,
            painted(Pattern::kPlain, 0xf6f3ea, 0, 0, seed + 37U));
}

void add_storage(Room& room, std::uint32_t seed) {
  const auto birch = room.add(painted(Pattern::kWood, 0xdcc49a, 0xc4a873, 0, seed + 40U));
  const auto steel = room.add(painted(Pattern::kPlain, 0x7d868c, 0, 0, seed + 41U, 0.35F));
  const auto dark = room.add(painted(Pattern::kPlain, 0x2c2e33, 0, 0, seed + 42U, 0.15F));
  add_bookshelf(room, standing_at(-0.55F, 2.34F, 3.1416F), birch, {1.00F, 1.60F, 0.30F},
                seed + 43U);
  add_sideboard(room, standing_at(-0.9F, -2.27F), steel, dark, {1.35F, 0.70F, 0.42F});
  add_book_row(room, standing_at(-1.5F, -2.12F) * Eigen::Translation3f(0, 0.70F, 0), 0.6F, 0.29F,
               seed + 44U);
  add_plant(room, standing_at(2.60F, -1.20F), seed + 45U);
  add_plant(room, standing_at(-2.55F, 2.05F), seed + 46U);
  const auto carton =
      room.add(painted(Pattern::kDrawings, 0xb08a5a, 0x4a3018, 0x7a2a2a, seed + 47U));
  add_box(room.mesh, carton, standing_at(2.62F, 1.55F, 0.2F), {-0.20F, 0, -0.25F},
          {0.20F, 0.34F, 0.25F});
  add_box(room.mesh, carton, standing_at(2.66F, 1.50F, 0.45F), {-0.16F, 0.34F, -0.2F},
          {0.16F, 0.60F, 0.2F});
  Surface panel = painted(Pattern::kPlain, 0xfff8ec, 0, 0, seed + 48U);
  panel.glow = 1.0F;
  const auto light = room.add(panel);
  for (const float x : {-1.2F, 1.2F}) {
    add_box(room.mesh, light, Affine3f::Identity(), {x - 0.6F, 2.56F, -0.3F},
            {x + 0.6F, 2.64F, 0.3F});
  }
}

Clothes walker_clothes(std::uint32_t seed) {
  Clothes clothes;
  clothes.shirt = painted(Pattern::kPlaid, 0xdfe6ec, 0x4a74a8, 0x8fb0cf, seed + 70U);
  clothes.trousers = painted(Pattern::kFabric, 0x4f4a44, 0x6a635a, 0, seed + 71U, 0.3F);
  clothes.shoes = painted(Pattern::kPlain, 0x1f1c1a, 0, 0, seed + 72U, 0.1F);
  clothes.skin = painted(Pattern::kPlain, 0x9a6a48, 0, 0, seed + 73U, 0.5F);
  clothes.face = painted(Pattern::kFace, 0x9a6a48, 0x7a3f38, 0x1a100c, seed + 73U, 0.5F);
  clothes.hair = painted(Pattern::kFabric, 0x1c1613, 0x0e0b09, 0, seed + 74U, 0.08F);
  return clothes;
}

}  // namespace

Room build_office(std::uint32_t seed) {
  Room room;
  room.name = "office";
  room.size_m = {6.2F, 2.7F, 5.2F};
  add_walls(room, seed);
  add_desks(room, seed);
  add_walls_things(room, seed);
  add_storage(room, seed);
  room.lights = {{{-1.2F, 2.5F, 0.0F}, {1.6F, 1.65F, 1.6F}, {0, -1, 0}, 0.4F},
                 {{1.2F, 2.5F, 0.0F}, {1.6F, 1.65F, 1.6F}, {0, -1, 0}, 0.4F},
                 {{2.95F, 1.65F, 0.35F}, {2.4F, 2.7F, 3.1F}, {-1, -0.1F, 0}, 0.5F}};
  room.ambient = {0.46F, 0.47F, 0.48F};
  room.stands = {{{{-2.75F, 2.00F, -2.25F}, {0.50F, 0.80F, 0.40F}},
                  {{2.75F, 1.80F, -2.10F}, {-0.60F, 0.75F, 0.30F}},
                  {{0.40F, 2.15F, 2.45F}, {0.10F, 0.85F, -0.60F}},
                  {{-2.30F, 1.60F, 2.40F}, {0.60F, 0.80F, -0.50F}},
                  {{2.70F, 1.90F, 2.35F}, {-0.40F, 0.75F, -0.20F}},
                  {{0.30F, 1.45F, -2.45F}, {0.10F, 0.85F, 0.40F}},
                  {{-2.95F, 2.10F, 0.05F}, {0.40F, 0.80F, 0.00F}},
                  {{2.90F, 1.30F, -0.80F}, {-0.40F, 0.90F, 0.10F}}}};
  room.walk = {{0.45F, -0.35F}, {1.25F, 0.95F}, std::chrono::seconds(8), 5};
  room.clothes = walker_clothes(seed);
  return room;
}

}  // namespace roomcast::sim
