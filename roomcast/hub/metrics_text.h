// SPDX-License-Identifier: Apache-2.0
// `/metrics`: how the rooms of a hub are doing, in the text format of Prometheus (version 0.0.4).
// Threading: no state.
#pragma once

#include <span>
#include <string>

#include "roomcast/hub/room_stats.h"

namespace roomcast::hub {

/// What concerns no single room.
struct HubStats {
  std::size_t connections = 0;      // of all kinds
  std::uint64_t refused_joins = 0;  // for want of a good token
  std::size_t banned_peers = 0;
};

[[nodiscard]] std::string metrics_text(const HubStats& hub, std::span<const RoomStats> rooms);

}  // namespace roomcast::hub
