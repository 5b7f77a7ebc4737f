// SPDX-License-Identifier: Apache-2.0
// `/metrics`: the state of a hub and its rooms in the text format of Prometheus (version 0.0.4).
// docs/guides/metrics.md describes all metrics. Threading: no state.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/server/process_stats.h"

namespace roomcast::hub {

/// The metrics that belong to no single room.
struct HubStats {
  std::string version = {};
  ProcessStats process = {};
  std::size_t connections = 0;      // HTTP and WebSockets
  std::uint64_t refused_joins = 0;  // joins that access control refused
  std::size_t banned_peers = 0;
  std::optional<BackplaneStats> backplane = {};  // nothing: there is no backplane
};

[[nodiscard]] std::string metrics_text(const HubStats& hub, std::span<const RoomStats> rooms);

}  // namespace roomcast::hub
