// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/room_bridge.h"

#include <chrono>
#include <utility>

#include "roomcast/recording/live_sets/live_sets.h"

namespace roomcast::foxglove {
namespace {

constexpr std::chrono::milliseconds kLook{100};  // for the end, without news of the room

}  // namespace

Status bridge_room(const client::Subscriber& room, FoxgloveServer& server,
                   const RoomBridgeOptions& options, const std::stop_token& stop) {
  recording::LiveSets sets;
  Topics topics(options.topics);
  const Topics::Publish publish = [&](ChannelId channel, nanoseconds time, std::string message) {
    server.publish(channel, time, std::move(message));
  };
  server.set_channels(topics.channels());
  std::uint64_t revision = 0;
  bool reported = false;  // a picture that cannot be made; once is enough
  while (!stop.stop_requested()) {
    if (auto failure = room.failure()) return *failure;
    const auto snapshot = room.wait_newer(revision, kLook);
    if (snapshot->revision == revision) continue;
    revision = snapshot->revision;
    if (!snapshot->connected) continue;
    if (auto status = client::check_may_export(snapshot->rights); !status) return status;
    const recording::LiveSet live = sets.set_of(*snapshot);
    if (topics.set_sensors(live.sensors)) server.set_channels(topics.channels());
    const auto wanted = server.wanted();
    if (wanted.empty()) continue;
    const Status published = topics.publish(live.set, wanted, publish);
    if (!published && options.log && !std::exchange(reported, true))
      options.log(LogLevel::kWarning, published.error().message);
  }
  return {};
}

}  // namespace roomcast::foxglove
