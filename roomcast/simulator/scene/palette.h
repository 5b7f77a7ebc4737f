// SPDX-License-Identifier: Apache-2.0
// Palette: the surfaces that many objects of one room share, with colours and cloths drawn at
// random.
#pragma once

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/furniture.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

struct Palette {
  SurfaceIndex wood, dark_wood;  // of most furniture; of legs and frames
  SurfaceIndex cloth, other_cloth;
  SurfaceIndex metal, dark, white;
  SurfaceIndex lampshade;
};
[[nodiscard]] Palette draw_palette(Room& room, Random& random);

enum class FloorKind { kBoards, kCarpet, kTerrazzo, kConcrete };
/// Floor, ceiling, skirting and walls with texture: brick, wallpaper, plaster.
void add_homely_shell(Room& room, FloorKind floor, Random& random);
/// Painted walls, one of them in another colour.
void add_plain_shell(Room& room, FloorKind floor, Random& random);

/// A person with random build, clothes, skin and hair, and no activities yet.
[[nodiscard]] Person draw_person(Room& room, Random& random);

}  // namespace roomcast::simulator
