// SPDX-License-Identifier: Apache-2.0
// The kinds of room there are, each drawn from a seed: where things stand, which and how large they
// are, their colours and pictures, who is there and what they do. Nothing when the random left no
// place for what the scene cannot do without; another seed will.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// 5.6..6.2 x 4.8..5.2 m. Somebody walks about, sits down on the sofa and looks for a book.
std::optional<Room> try_livingroom(std::uint32_t seed);
/// Desks: somebody types, somebody walks between shelf and whiteboard.
std::optional<Room> try_office(std::uint32_t seed);
/// Benches and racks: somebody carries a monitor to a bench, plugs it in, and carries it back.
std::optional<Room> try_lab(std::uint32_t seed);
/// A long table: one sits and talks with their hands, one writes on the board.
std::optional<Room> try_meeting(std::uint32_t seed);
/// A floor to move on, cameras on tripods round it: two people exercise, walk up and down, stretch.
std::optional<Room> try_studio(std::uint32_t seed);
/// Little furniture, walls and floor with next to nothing to see in them.
std::optional<Room> try_bare(std::uint32_t seed);
/// A floor that repeats exactly, identical posters, rows of identical chairs, the same again when
/// the room is turned half round; and 0 to 3 things that are there once, as the seed says.
std::optional<Room> try_mirror_tiles(std::uint32_t seed);
/// 5 x 4.2 m with sensors in its corners.
std::optional<Room> try_corners(std::uint32_t seed);

}  // namespace roomcast::simulator
