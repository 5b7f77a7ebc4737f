// SPDX-License-Identifier: Apache-2.0
// RoomBridge: a running room as topics of a FoxgloveServer. A room whose admin does not permit
// exporting is not bridged. When the bridge is slower than the room, it leaves out frame sets.
#pragma once

#include <stop_token>

#include "roomcast/client/subscriber.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/foxglove/foxglove_server.h"
#include "roomcast/foxglove/topics.h"

namespace roomcast::foxglove {

struct RoomBridgeOptions {
  TopicsOptions topics;
  LogSink log = {};
};

/// Bridges until `stop`, or until the connection to the hub ends for good: its reason. kUnavailable
/// if the room may not be exported.
[[nodiscard]] Status bridge_room(const client::Subscriber& room, FoxgloveServer& server,
                                 const RoomBridgeOptions& options, const std::stop_token& stop);

}  // namespace roomcast::foxglove
