// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/room_bridge.h"

#include <chrono>
#include <utility>

#include "roomcast/recording/live_sets/live_sets.h"

namespace roomcast::ros2 {
namespace {

constexpr std::chrono::milliseconds kLook{100};  // for the end, without news of the room

}  // namespace

Status bridge_room(const client::Subscriber& room, RoomTopics& topics,
                   const RoomBridgeOptions& options, const std::stop_token& stop) {
  recording::LiveSets sets;
  std::vector<std::string> told;
  std::uint64_t revision = 0;
  bool reported = false;  // a message that cannot be sent; once is enough
  while (!stop.stop_requested()) {
    if (auto failure = room.failure()) return *failure;
    const auto snapshot = room.wait_newer(revision, kLook);
    if (snapshot->revision == revision) continue;
    revision = snapshot->revision;
    if (!snapshot->connected) continue;
    if (Status status = client::check_may_export(snapshot->rights); !status) return status;
    const recording::LiveSet live = sets.set_of(*snapshot);
    if (Status status = topics.set_sensors(live.sensors); !status) return status;
    if (auto names = topics.names(); options.on_topics && names != told)
      options.on_topics(told = std::move(names));
    const Status published = topics.publish(live.set);
    if (!published && options.log && !std::exchange(reported, true))
      options.log(LogLevel::kWarning, published.error().message);
  }
  return {};
}

}  // namespace roomcast::ros2
