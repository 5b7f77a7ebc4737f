// SPDX-License-Identifier: Apache-2.0
// The kinds of rooms. The seed determines the layout, the objects and their sizes, colours and
// pictures, the people and their activities. A function returns nothing if the random layout has no
// space for a required object; another seed will work.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// 5.6..6.2 x 4.8..5.2 m. A person walks about, sits down on the sofa and looks for a book.
std::optional<Room> try_livingroom(std::uint32_t seed);
/// Desks: one person types, another walks between shelf and whiteboard.
std::optional<Room> try_office(std::uint32_t seed);
/// Benches and racks: a person carries a monitor to a bench, plugs it in, and carries it back.
std::optional<Room> try_lab(std::uint32_t seed);
/// A long table: one person sits and gestures, another writes on the board.
std::optional<Room> try_meeting(std::uint32_t seed);
/// Free floor with cameras on tripods around it: two people exercise, walk up and down, stretch.
std::optional<Room> try_studio(std::uint32_t seed);
/// Little furniture; walls and floor almost without texture.
std::optional<Room> try_bare(std::uint32_t seed);
/// A floor that repeats exactly, identical posters and rows of identical chairs, symmetric under
/// rotation of the room by 180 degrees; plus 0 to 3 unique objects, depending on the seed.
std::optional<Room> try_mirror_tiles(std::uint32_t seed);
/// 5 x 4.2 m with sensors in its corners.
std::optional<Room> try_corners(std::uint32_t seed);

// Rooms that are hard to align (kHarshSceneNames).

/// 5.8..6.6 x 5.2..5.8 m: rows of equal shelves on both sides of an aisle.
std::optional<Room> try_shelf_rows(std::uint32_t seed);
/// 5.8..6.6 x 5.0..5.6 m: two rows of equal desks and chairs.
std::optional<Room> try_desk_rows(std::uint32_t seed);
/// Looks alike after half a turn, but for 0 to 3 unique objects.
std::optional<Room> try_half_turn_hall(std::uint32_t seed);
/// 15..17 x 13..15 m: sensors around its middle; the walls are beyond their range.
std::optional<Room> try_open_plan(std::uint32_t seed);
/// `lab` on polished stone.
std::optional<Room> try_glossy_floor(std::uint32_t seed);
/// `meeting` on black carpet.
std::optional<Room> try_dark_floor(std::uint32_t seed);

}  // namespace roomcast::simulator
