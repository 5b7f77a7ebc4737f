// SPDX-License-Identifier: Apache-2.0
// Adds a person who carries a board with an AprilTag through the room and pauses regularly so that
// sensors can detect it: an option for every room in which a person walks. Metres.
#pragma once

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// Side of the black square, as printed on an A3 page.
inline constexpr float kBoardTagSide_m = 0.2216F;
/// AprilTag 36h11 number 0.
inline constexpr int kBoardTag = 0;

/// The first of the room's people carries the board; the others are removed. Returns false without
/// changes if no person walks about.
[[nodiscard]] bool add_board_bearer(Room& room);

}  // namespace roomcast::simulator
