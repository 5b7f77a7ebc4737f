// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/palette.h"

#include <array>

namespace roomcast::simulator {
namespace {

struct Tones {
  std::uint32_t base, accent;
};

constexpr std::array<Tones, 6> kWoods = {{{0xb98a55, 0x8a5f33},
                                          {0x7a4e2c, 0x53331b},
                                          {0xd8b98a, 0xbf9a66},
                                          {0xc79a62, 0xa5763f},
                                          {0xdcc49a, 0xc4a873},
                                          {0x8f6a48, 0x6a4a2e}}};
constexpr std::array<Tones, 8> kCloths = {{{0x3f6f78, 0x5d929a},
                                           {0x8c3a34, 0xae5a4e},
                                           {0x6f7a4a, 0x8e9a62},
                                           {0xc7b48f, 0x9d8a66},
                                           {0x4a5568, 0x68758c},
                                           {0xb8863a, 0xd0a45a},
                                           {0x7a5a78, 0x9a7a96},
                                           {0x2f4f86, 0x4a6fae}}};
constexpr std::array<Tones, 5> kWalls = {
    {{0xe0d3ba, 0}, {0xd9dcd8, 0}, {0xe6e0d2, 0}, {0xcfd8d4, 0}, {0xdcd2cc, 0}}};
constexpr std::array<Tones, 5> kBoldWalls = {
    {{0x8fae9a, 0}, {0xb07a5a, 0}, {0x6f8aa4, 0}, {0xc8a860, 0}, {0x9a8a9e, 0}}};

SurfaceIndex add_floor(Room& room, FloorKind kind, Random& random) {
  constexpr std::array<std::array<std::uint32_t, 2>, 4> kBoards = {
      {{0xa9763f, 0x7d4f27}, {0xc49a66, 0x9a7042}, {0x8a6a4a, 0x5f4630}, {0xb89068, 0x8a6440}}};
  constexpr std::array<std::array<std::uint32_t, 2>, 4> kCarpets = {
      {{0x4a5560, 0x6d7780}, {0x5a4a44, 0x7a685e}, {0x44564e, 0x647a6e}, {0x565268, 0x726e88}}};
  switch (kind) {
    case FloorKind::kBoards: {
      const auto& tones = random.one_of(kBoards);
      return room.add(painted(Pattern::kPlanks, tones[0], tones[1], 0x2a1a0e, random.seed()));
    }
    case FloorKind::kCarpet: {
      const auto& tones = random.one_of(kCarpets);
      return room.add(painted(Pattern::kCarpetTiles, tones[0], tones[1], 0, random.seed(), 0.4F));
    }
    case FloorKind::kTerrazzo:
      return room.add(
          painted(Pattern::kTerrazzo, 0xcfcac0, 0x8a8078, 0x4a4640, random.seed(), 0.5F));
    case FloorKind::kConcrete:
      break;
  }
  return room.add(painted(Pattern::kConcrete, 0x8f918e, 0x74777a, 0x505254, random.seed(), 0.4F));
}

SurfaceIndex add_homely_wall(Room& room, Random& random) {
  constexpr std::array<std::array<std::uint32_t, 3>, 3> kPapers = {
      {{0xc9d2c2, 0x8fa68f, 0xe7c9a0},
       {0xd8c8c0, 0xa87a70, 0xf0e0c0},
       {0xc4ccd8, 0x7f92ae, 0xe8d8b0}}};
  switch (random.below(4)) {
    case 0: {
      const auto& paper = random.one_of(kPapers);
      return room.add(
          painted(Pattern::kWallpaper, paper[0], paper[1], paper[2], random.seed(), 0.6F));
    }
    case 1:
      return room.add(painted(Pattern::kBrick, 0x9c5a42, 0xb98263, 0xbdb3a2, random.seed()));
    default:
      return room.add(
          painted(Pattern::kPlaster, random.one_of(kWalls).base, 0, 0, random.seed(), 0.6F));
  }
}

ShellSurfaces base_of_shell(Room& room, FloorKind floor, Random& random) {
  ShellSurfaces shell{};
  shell.floor = add_floor(room, floor, random);
  shell.ceiling = room.add(painted(Pattern::kPlaster, 0xe9e7e0, 0, 0, random.seed(), 0.6F));
  shell.skirting = room.add(painted(
      Pattern::kPlain, floor == FloorKind::kBoards ? 0xf1eee6 : 0x5c5f62, 0, 0, random.seed()));
  return shell;
}

Surface varnished(Surface surface) {
  surface.gloss = 0.04F;
  surface.polish = 200.0F;
  return surface;
}

}  // namespace

Palette draw_palette(Room& room, Random& random) {
  Palette p{};
  const Tones wood = random.one_of(kWoods), dark = random.one_of(kWoods);
  const Tones cloth = random.one_of(kCloths), other = random.one_of(kCloths);
  p.wood = room.add(varnished(painted(Pattern::kWood, wood.base, wood.accent, 0, random.seed())));
  p.dark_wood =
      room.add(varnished(painted(Pattern::kWood, dark.base, dark.accent, 0, random.seed())));
  p.cloth = room.add(painted(Pattern::kFabric, cloth.base, cloth.accent, 0, random.seed()));
  p.other_cloth = room.add(painted(Pattern::kFabric, other.base, other.accent, 0, random.seed()));
  Surface metal = painted(Pattern::kPlain, 0x9a9ea2, 0, 0, random.seed(), 0.4F);
  metal.gloss = 0.5F;  // brushed
  metal.polish = 60.0F;
  p.metal = room.add(metal);
  p.dark = room.add(painted(Pattern::kPlain, 0x2c2e33, 0, 0, random.seed(), 0.15F));
  p.white = room.add(painted(Pattern::kPlain, 0xeeece6, 0, 0, random.seed()));
  Surface shade = painted(Pattern::kFabric, 0xf2dfb6, 0xe8cf9a, 0, random.seed());
  shade.glow = 0.8F;
  p.lampshade = room.add(shade);
  return p;
}

void add_homely_shell(Room& room, FloorKind floor, Random& random) {
  ShellSurfaces shell = base_of_shell(room, floor, random);
  for (auto& wall : shell.walls) wall = add_homely_wall(room, random);
  add_shell(room, shell);
}

void add_plain_shell(Room& room, FloorKind floor, Random& random) {
  ShellSurfaces shell = base_of_shell(room, floor, random);
  const auto common =
      room.add(painted(Pattern::kPlaster, random.one_of(kWalls).base, 0, 0, random.seed(), 0.6F));
  shell.walls.fill(common);
  const auto bold = static_cast<std::size_t>(random.below(4));
  shell.walls[bold] = room.add(
      painted(Pattern::kPlaster, random.one_of(kBoldWalls).base, 0, 0, random.seed(), 0.5F));
  add_shell(room, shell);
}

Person draw_person(Room& room, Random& random) {
  constexpr std::array<std::uint32_t, 5> kSkins = {0xe2b698, 0xd0a080, 0xb07a56, 0x8a5a3c,
                                                   0x6a4430};
  constexpr std::array<Tones, 5> kHair = {{{0x3a2415, 0x22140b},
                                           {0x1c1613, 0x0e0b09},
                                           {0x8a5f30, 0x6a4520},
                                           {0x8a8680, 0x6e6a66},
                                           {0x5a2c16, 0x401c0c}}};
  constexpr std::array<Tones, 6> kShirts = {{{0x8f2323, 0xe0d4b8},
                                             {0x2f5a8a, 0xe8ecf0},
                                             {0x2f6a4a, 0xd8d0a0},
                                             {0xd8d4c8, 0x4a5a78},
                                             {0xc89a30, 0x5a3a1a},
                                             {0x6a3a68, 0xc8a8c8}}};
  constexpr std::array<Tones, 4> kTrousers = {
      {{0x24344f, 0x4d6a8f}, {0x4f4a44, 0x6a635a}, {0x2a2c30, 0x44474c}, {0x8a7a5a, 0xa69474}}};
  constexpr std::array<Pattern, 4> kWeaves = {Pattern::kPlaid, Pattern::kStripes, Pattern::kFabric,
                                              Pattern::kFabric};
  constexpr std::array<HairStyle, 4> kStyles = {HairStyle::kShort, HairStyle::kLong,
                                                HairStyle::kBun, HairStyle::kCurly};
  Person person;
  person.build.height_m = random.between(1.60F, 1.90F);
  person.build.girth = random.between(0.92F, 1.22F);
  person.build.hair = random.one_of(kStyles);
  person.build.sleeve = random.chance(0.35F) ? -0.45F : 0.92F;
  const auto skin = random.one_of(kSkins);
  const Tones hair = random.one_of(kHair), shirt = random.one_of(kShirts),
              legs = random.one_of(kTrousers);
  Outfit& worn = person.outfit;
  Surface top = painted(random.one_of(kWeaves), shirt.base, shirt.accent, 0x1f2a44, random.seed());
  top.size_m = {1.0F, random.between(0.02F, 0.05F)};
  if (top.pattern == Pattern::kFabric) top.accent = top.base * 0.75F;
  worn.shirt = room.add(top);
  worn.trousers = room.add(painted(random.chance(0.5F) ? Pattern::kDenim : Pattern::kFabric,
                                   legs.base, legs.accent, legs.accent, random.seed(), 0.35F));
  worn.shoes = room.add(painted(Pattern::kPlain, random.chance(0.5F) ? 0x5a3a22 : 0x26262a, 0, 0,
                                random.seed(), 0.25F));
  worn.skin = room.add(painted(Pattern::kPlain, skin, 0, 0, random.seed(), 0.55F));
  worn.face = room.add(painted(Pattern::kFace, skin, 0xb05f55, 0x2a1a12, random.seed(), 0.55F));
  worn.hair = room.add(painted(Pattern::kFabric, hair.base, hair.accent, 0, random.seed(), 0.12F));
  return person;
}

}  // namespace roomcast::simulator
