// SPDX-License-Identifier: Apache-2.0
// A cabinet that somebody moves: it stands in one of two places of a furnished room. They are where
// nothing else stands and nobody walks, as near to the middle of the room as possible. Metres,
// world frame of room.h.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// A room as it is without the cabinet has these two places, the same whenever it is asked; nothing
/// where it has not so much space.
[[nodiscard]] std::optional<std::array<Eigen::AlignedBox3f, 2>> cabinet_places(const Room& room);

/// `place`: 0 or 1. False, without changes: the room has no places for it.
[[nodiscard]] bool add_cabinet(Room& room, int place);

}  // namespace roomcast::simulator
