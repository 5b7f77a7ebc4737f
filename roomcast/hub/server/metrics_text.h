// SPDX-License-Identifier: Apache-2.0
// `/metrics`: how a hub and its rooms are doing, in the text format of Prometheus (version 0.0.4).
// All are described in docs/guides/metrics.md.
// Threading: no state.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/server/process_stats.h"

namespace roomcast::hub {

/// What concerns no single room.
struct HubStats {
  std::string version = {};
  ProcessStats process = {};
  std::size_t connections = 0;      // of all kinds
  std::uint64_t refused_joins = 0;  // for want of a good token
  std::size_t banned_peers = 0;
  std::optional<BackplaneStats> backplane = {};  // nothing: this hub is alone
};

[[nodiscard]] std::string metrics_text(const HubStats& hub, std::span<const RoomStats> rooms);

}  // namespace roomcast::hub
