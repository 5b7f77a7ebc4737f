// SPDX-License-Identifier: Apache-2.0
// RoomBridge: a running room as topics of ROS 2. A room whose admin does not permit exporting is
// not bridged. When the bridge is slower than the room, it leaves out frame sets.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/client/subscriber.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/ros2/bridge/room_topics.h"

namespace roomcast::ros2 {

struct RoomBridgeOptions {
  LogSink log = {};
  /// Called when the topics have changed, and at the beginning.
  std::function<void(const std::vector<std::string>& names)> on_topics = {};
};

/// Bridges until `stop`, or until the connection to the hub ends for good: its reason. kUnavailable
/// if the room may not be exported.
[[nodiscard]] Status bridge_room(const client::Subscriber& room, RoomTopics& topics,
                                 const RoomBridgeOptions& options, const std::stop_token& stop);

}  // namespace roomcast::ros2
