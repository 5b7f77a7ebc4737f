// SPDX-License-Identifier: Apache-2.0
// Somebody who carries a board with an AprilTag on it about the room, and stands still here
// and there so that sensors see it: an option of every room in which somebody walks. Metres.
#pragma once

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// The black square's side: as on an A3 page.
inline constexpr float kBoardTagSide_m = 0.2216F;
/// AprilTag 36h11 number 0.
inline constexpr int kBoardTag = 0;

/// The first of the room's people takes up the board; the others leave. False, and nothing changes,
/// where nobody walks about.
[[nodiscard]] bool add_board_bearer(Room& room);

}  // namespace roomcast::simulator
