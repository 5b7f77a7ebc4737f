// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/scene/livingroom.h"

#include <array>
#include <cmath>

#include "roomcast/source/simulator/scene/furniture.h"
#include "roomcast/source/simulator/scene/value_noise.h"

namespace roomcast::sim {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

Surface picture(Vector2f size_m, std::uint32_t base, std::uint32_t accent, std::uint32_t seed) {
  Surface surface = painted(Pattern::kPainting, base, accent, 0x202020, seed);
  surface.size_m = size_m;
  return surface;
}

void add_walls(Room& room, std::uint32_t seed) {
  ShellSurfaces shell{};
  shell.floor = room.add(painted(Pattern::kPlanks, 0xa9763f, 0x7d4f27, 0x2a1a0e, seed));
  shell.ceiling = room.add(painted(Pattern::kPlaster, 0xe9e6de, 0, 0, seed + 1U, 0.6F));
  shell.skirting = room.add(painted(Pattern::kPlain, 0xf1eee6, 0, 0, seed + 2U));
  shell.walls = {
      room.add(painted(Pattern::kWallpaper, 0xc9d2c2, 0x8fa68f, 0xe7c9a0, seed + 3U, 0.6F)),
      room.add(painted(Pattern::kPlaster, 0xe0d3ba, 0, 0, seed + 4U, 0.6F)),
      room.add(painted(Pattern::kPlaster, 0xd9cdb8, 0, 0, seed + 5U, 0.6F)),
      room.add(painted(Pattern::kBrick, 0x9c5a42, 0xb98263, 0xbdb3a2, seed + 6U))};
  add_shell(room, shell);
}

void add_sofa_corner(Room& room, std::uint32_t seed) {
  const auto cloth = room.add(painted(Pattern::kFabric, 0x3f6f78, 0x5d929a, 0, seed + 10U));
  const auto oak = room.add(painted(Pattern::kWood, 0xb98a55, 0x8a5f33, 0, seed + 11U));
  Surface carpet = painted(Pattern::kRug, 0x7a2a2a, 0x23364f, 0xd8c49a, seed + 12U);
  carpet.size_m = {2.0F, 2.6F};
  add_quad(room.mesh, room.add(carpet), Affine3f::Identity(), {-2.35F, 0.008F, 1.25F}, {2.0F, 0, 0},
           {0, 0, -2.6F});
  const Affine3f sofa = standing_at(-2.48F, -0.05F, 1.5708F);
  add_sofa(room, sofa, cloth, oak, 2.15F);
  add_throw_cushion(room, sofa,
                    room.add(painted(Pattern::kPlaid, 0xd8a13a, 0x8c2f2b, 0xf0e4c8, seed + 13U)),
                    {-0.62F, 0.67F, 0.03F}, 0.45F);
  add_throw_cushion(
      room, sofa, room.add(painted(Pattern::kWallpaper, 0xe8e0cf, 0x35546e, 0xb8552f, seed + 14U)),
      {0.66F, 0.67F, 0.02F}, -0.4F);
  const Affine3f table = standing_at(-1.22F, -0.05F, 1.5708F);
  add_table(room, table, oak, {1.15F, 0.42F, 0.58F});
  const Affine3f on_top = table * Eigen::Translation3f(0, 0.42F, 0);
  for (int i = 0; i < 3; ++i) {
    const auto book_seed = seed + 20U + static_cast<std::uint32_t>(i);
    const auto book =
        room.add(painted(Pattern::kPainting, 0x35546e, 0xc9a24a, 0x202020, 2U * book_seed + 1U));
    const float y = 0.028F * static_cast<float>(i);
    const Affine3f turned =
        on_top * Eigen::AngleAxisf(0.25F * static_cast<float>(i) - 0.2F, Vector3f::UnitY());
    add_box(room.mesh, book, turned, {-0.42F, y, -0.10F}, {-0.14F, y + 0.026F, 0.11F});
  }
  const std::array<Vector2f, 6> bowl = {Vector2f(0.05F, 0), {0.05F, 0.01F}, {0.13F, 0.06F},
                                        {0.15F, 0.09F},     {0.13F, 0.07F}, {0, 0.02F}};
  const Affine3f bowl_at = on_top * Eigen::Translation3f(0.28F, 0, 0.02F);
  add_turned(room.mesh, room.add(painted(Pattern::kPlain, 0x2f5f8a, 0, 0, seed + 24U)), bowl_at,
             bowl);
  const std::array<std::uint32_t, 4> fruit = {0xc8402a, 0xe0a030, 0x7fa43a, 0xd8702a};
  for (std::size_t i = 0; i < fruit.size(); ++i) {
    const float angle = 1.57F * static_cast<float>(i);
    const auto skin = room.add(painted(Pattern::kPlain, fruit[i], 0, 0, seed + 25U));
    add_cushion(room.mesh, skin, bowl_at,
                {0.05F * std::cos(angle), 0.085F, 0.05F * std::sin(angle)},
                Vector3f::Constant(0.04F), 1.0F);
  }
}

void add_dining_corner(Room& room, std::uint32_t seed) {
  const auto walnut = room.add(painted(Pattern::kWood, 0x7a4e2c, 0x53331b, 0, seed + 30U));
  const auto seat = room.add(painted(Pattern::kFabric, 0xc7b48f, 0x9d8a66, 0, seed + 31U));
  const Affine3f table = standing_at(1.05F, 1.62F, 0.06F);
  add_table(room, table, walnut, {1.35F, 0.74F, 0.80F});
  add_chair(room, standing_at(0.18F, 1.60F, 1.45F), walnut, seat);
  add_chair(room, standing_at(1.95F, 1.66F, -1.70F), walnut, seat);
  add_chair(room, standing_at(0.80F, 1.02F, 0.1F), walnut, seat);
  add_chair(room, standing_at(1.42F, 1.08F, -0.15F), walnut, seat);
  const Affine3f on_top = table * Eigen::Translation3f(0, 0.74F, 0);
  const std::array<Vector2f, 6> vase = {Vector2f(0, 0), {0.05F, 0},     {0.085F, 0.10F},
                                        {0.04F, 0.20F}, {0.05F, 0.24F}, {0.03F, 0.20F}};
  add_turned(room.mesh,
             room.add(painted(Pattern::kWallpaper, 0xdfe6ea, 0x27508c, 0x27508c, seed + 32U)),
             on_top * Eigen::Translation3f(0.08F, 0, 0.02F), vase);
  const std::array<Vector2f, 4> plate = {
      Vector2f(0.07F, 0), {0.13F, 0.018F}, {0.12F, 0.018F}, {0, 0.006F}};
  const std::array<Vector2f, 4> mug = {
      Vector2f(0, 0), {0.04F, 0}, {0.042F, 0.095F}, {0.036F, 0.095F}};
  for (const float x : {-0.42F, 0.45F}) {
    add_turned(room.mesh, room.add(painted(Pattern::kPlain, 0xf0ede4, 0, 0, seed + 33U)),
               on_top * Eigen::Translation3f(x, 0, 0.05F), plate);
    add_turned(room.mesh,
               room.add(painted(Pattern::kPlain, x < 0 ? 0xb83a30 : 0x2f6f5a, 0, 0, seed + 34U)),
               on_top * Eigen::Translation3f(x + 0.06F, 0, -0.22F), mug);
  }
}

void add_television_wall(Room& room, std::uint32_t seed) {
  const auto white = room.add(painted(Pattern::kWood, 0xd9d2c4, 0xc2b8a4, 0, seed + 40U));
  const auto metal = room.add(painted(Pattern::kPlain, 0x3a3a3c, 0, 0, seed + 41U, 0.3F));
  const auto frame = room.add(painted(Pattern::kPlain, 0xf4f2ec, 0, 0, seed + 42U));
  add_sideboard(room, standing_at(1.25F, -2.27F), white, metal, {1.80F, 0.52F, 0.42F});
  const auto television = room.add(painted(Pattern::kPlain, 0x101114, 0, 0, seed + 43U, 0.03F));
  const Affine3f at = standing_at(1.25F, -2.30F) * Eigen::Translation3f(0, 0.52F, 0);
  add_box(room.mesh, television, at, {-0.20F, 0, -0.08F}, {0.20F, 0.02F, 0.10F});
  add_box(room.mesh, television, at, {-0.55F, 0.06F, -0.02F}, {0.55F, 0.70F, 0.02F});
  add_book_row(room, standing_at(1.90F, -2.12F) * Eigen::Translation3f(-0.02F, 0.52F, 0), 0.26F,
               0.26F, seed + 44U);
  Surface view = painted(Pattern::kGarden, 0x2f5a26, 0x86a850, 0, seed + 45U, 0.0F);
  view.size_m = {1.30F, 1.25F};
  view.glow = 1.0F;
  const auto curtain = room.add(painted(Pattern::kFabric, 0xb86a4a, 0xd09a72, 0, seed + 46U));
  add_window(room, on_wall(room, 2, -1.15F, 1.55F), frame, view, curtain);
  add_radiator(room, on_wall(room, 2, -1.15F, 0.0F), frame, 1.1F);
  const auto dark = room.add(painted(Pattern::kWood, 0x2a2420, 0x1c1714, 0, seed + 47U, 0.25F));
  add_picture(room, on_wall(room, 2, 2.42F, 1.55F), dark,
              picture({0.42F, 0.56F}, 0x3b5a44, 0x22311f, 2U * seed + 6U));
}

void add_pictures(Room& room, std::uint32_t seed) {
  const auto gold = room.add(painted(Pattern::kWood, 0xb08d45, 0x7d5f25, 0, seed + 50U));
  const auto dark = room.add(painted(Pattern::kWood, 0x3a2a1e, 0x241810, 0, seed + 51U, 0.3F));
  add_picture(room, on_wall(room, 0, -0.05F, 1.62F), gold,
              picture({1.30F, 0.72F}, 0x4a7a68, 0x1d3026, 2U * seed));
  add_picture(room, on_wall(room, 0, 1.62F, 1.55F), dark,
              picture({0.45F, 0.60F}, 0xd9cfb8, 0x2a2a2a, 2U * seed + 1U));
  add_picture(room, on_wall(room, 3, 1.15F, 1.62F), dark,
              picture({0.95F, 0.70F}, 0xe6dcc8, 0x2a2a2a, 2U * seed + 3U));
  add_picture(room, on_wall(room, 3, -0.35F, 1.55F), gold,
              picture({0.50F, 0.65F}, 0x7a5a3a, 0x2f2418, 2U * seed + 2U));
  add_picture(room, on_wall(room, 3, -2.05F, 1.50F), dark,
              picture({0.60F, 0.45F}, 0x24476b, 0x2a2a2a, 2U * seed + 5U));
  add_picture(room, on_wall(room, 1, 1.95F, 1.60F), gold,
              picture({0.40F, 0.50F}, 0xcab890, 0x2a2a2a, 2U * seed + 7U));
  const auto rim = room.add(painted(Pattern::kPlain, 0x262626, 0, 0, seed + 52U, 0.3F));
  add_clock(room, on_wall(room, 1, -0.45F, 1.85F), rim,
            painted(Pattern::kPlain, 0xf6f3ea, 0, 0, seed + 53U));
}

void add_shelf_wall(Room& room, std::uint32_t seed) {
  const auto pine = room.add(painted(Pattern::kWood, 0xc79a62, 0xa5763f, 0, seed + 60U));
  const auto door = room.add(painted(Pattern::kWood, 0xe4dccb, 0xd2c7b0, 0, seed + 61U));
  const auto brass = room.add(painted(Pattern::kPlain, 0xa08a4a, 0, 0, seed + 62U));
  add_bookshelf(room, standing_at(2.84F, 0.85F, -1.5708F), pine, {1.20F, 1.95F, 0.30F}, seed + 63U);
  add_door(room, on_wall(room, 1, -1.25F, 0.0F), door, brass);
  add_plant(room, standing_at(-1.05F, 2.14F), seed + 64U);
  Surface shade = painted(Pattern::kFabric, 0xf2dfb6, 0xe8cf9a, 0, seed + 65U);
  shade.glow = 0.8F;
  const auto lampshade = room.add(shade);
  add_floor_lamp(room, standing_at(-2.66F, 1.62F), brass, lampshade);
  add_pendant_lamp(room, {0.55F, room.size_m.y(), -0.2F}, brass, lampshade);
  const auto crate = room.add(painted(Pattern::kWood, 0x9a7a4a, 0x76592f, 0, seed + 66U));
  add_box(room.mesh, crate, standing_at(2.55F, 2.05F, 0.3F), {-0.25F, 0, -0.18F},
          {0.25F, 0.32F, 0.18F});
  const auto ball = room.add(painted(Pattern::kPlaid, 0xd83a2a, 0xf0e4c8, 0x2a4a8c, seed + 67U));
  add_cushion(room.mesh, ball, standing_at(2.2F, -1.75F), {0, 0.12F, 0}, Vector3f::Constant(0.12F),
              1.0F);
}

Clothes walker_clothes(std::uint32_t seed) {
  Clothes clothes;
  clothes.shirt = painted(Pattern::kPlaid, 0x8f2323, 0x1f2a44, 0xe0d4b8, seed + 70U);
  clothes.trousers = painted(Pattern::kDenim, 0x24344f, 0x4d6a8f, 0xb89a5a, seed + 71U, 0.35F);
  clothes.shoes = painted(Pattern::kPlain, 0x5a3a22, 0, 0, seed + 72U, 0.3F);
  clothes.skin = painted(Pattern::kPlain, 0xd9a98a, 0, 0, seed + 73U, 0.6F);
  clothes.face = painted(Pattern::kFace, 0xd9a98a, 0xb05f55, 0x2a1a12, seed + 73U, 0.6F);
  clothes.hair = painted(Pattern::kFabric, 0x3a2415, 0x22140b, 0, seed + 74U, 0.12F);
  return clothes;
}

}  // namespace

Room build_livingroom(std::uint32_t seed) {
  Room room;
  room.name = "livingroom";
  room.size_m = {6.0F, 2.6F, 5.0F};
  add_walls(room, seed);
  add_sofa_corner(room, seed);
  add_dining_corner(room, seed);
  add_television_wall(room, seed);
  add_pictures(room, seed);
  add_shelf_wall(room, seed);
  room.lights = {{{0.55F, 2.05F, -0.2F}, {2.5F, 2.2F, 1.75F}, Vector3f::Zero(), 0.16F},
                 {{-1.15F, 1.6F, -2.35F}, {2.6F, 2.9F, 3.4F}, {0, -0.1F, 1}, 0.5F},
                 {{-2.66F, 1.5F, 1.62F}, {0.7F, 0.55F, 0.33F}, Vector3f::Zero(), 0.12F}};
  room.ambient = {0.42F, 0.41F, 0.40F};
  room.stands = {{{{-2.60F, 1.90F, -2.10F}, {0.50F, 0.80F, 0.35F}},
                  {{2.65F, 1.65F, -1.95F}, {-0.55F, 0.75F, 0.20F}},
                  {{0.25F, 2.10F, 2.30F}, {0.35F, 0.85F, -0.60F}},
                  {{-2.05F, 1.50F, 2.25F}, {0.70F, 0.80F, -0.50F}},
                  {{2.60F, 2.00F, 2.20F}, {-0.30F, 0.75F, -0.20F}},
                  {{0.05F, 1.40F, -2.30F}, {0.20F, 0.85F, 0.40F}},
                  {{-2.80F, 2.15F, 0.05F}, {0.40F, 0.80F, -0.10F}},
                  {{2.80F, 1.25F, -0.30F}, {-0.40F, 0.90F, 0.00F}}}};
  room.walk = {{0.62F, -0.50F}, {1.00F, 0.92F}, std::chrono::seconds(7), 5};
  room.clothes = walker_clothes(seed);
  return room;
}

}  // namespace roomcast::sim
