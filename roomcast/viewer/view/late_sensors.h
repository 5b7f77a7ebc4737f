// SPDX-License-Identifier: Apache-2.0
// Finds the sensors whose newest picture is old beside those of the others, because their line or
// machine is slow. Somebody who walks would be seen where they were, beside where they are.
#pragma once

#include <set>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/ids.h"

namespace roomcast::viewer {

/// Sensors that are online, not paused, and behind the newest picture of the room by more than
/// 0.3 s and 2.5 frames of their own. Empty with fewer than two sensors that have sent pictures.
[[nodiscard]] std::set<SensorId> late_sensors(const client::RoomSnapshot& room);

}  // namespace roomcast::viewer
