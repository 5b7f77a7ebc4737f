// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/room_bridge.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "roomcast/recording/live_sets/live_sets.h"

namespace roomcast::ros2 {
namespace {

constexpr std::chrono::milliseconds kLook{100};  // for the end, without news of the room

constexpr std::size_t kMaxTimes = 100'000;  // an hour at 30 sets a second

/// How long sets take from their arrival until they are handed to DDS.
class BridgeTimes {
 public:
  void add(nanoseconds time) {
    if (times_.size() < kMaxTimes) times_.push_back(time);
  }
  void tell(const LogSink& log) {
    if (!log || times_.empty()) return;
    log(LogLevel::kInfo, std::to_string(times_.size()) +
                             " frame sets: half were published within " + ms_of(0.5) +
                             " ms of their arrival, 99 in 100 within " + ms_of(0.99) + " ms");
  }

 private:
  std::string ms_of(double share) {
    const auto place = times_.begin() +
                       static_cast<std::ptrdiff_t>(share * static_cast<double>(times_.size() - 1));
    std::nth_element(times_.begin(), place, times_.end());
    std::string text = std::to_string(std::chrono::duration<double, std::milli>(*place).count());
    return text.substr(0, text.find('.') + 3);
  }
  std::vector<nanoseconds> times_;
};

}  // namespace

Status bridge_room(const client::Subscriber& room, RoomTopics& topics,
                   const RoomBridgeOptions& options, const std::stop_token& stop) {
  recording::LiveSets sets;
  std::vector<std::string> told;
  std::uint64_t revision = 0;
  BridgeTimes times;
  bool reported = false;  // a message that cannot be sent; once is enough
  while (!stop.stop_requested()) {
    if (auto failure = room.failure()) return *failure;
    const auto snapshot = room.wait_newer(revision, kLook);
    if (snapshot->revision == revision) continue;
    revision = snapshot->revision;
    const HostTime arrived = SteadyClock().now();
    if (!snapshot->connected) continue;
    if (Status status = client::check_may_export(snapshot->rights); !status) return status;
    const recording::LiveSet live = sets.set_of(*snapshot);
    if (Status status = topics.set_sensors(live.sensors); !status) return status;
    if (auto names = topics.names(); options.on_topics && names != told)
      options.on_topics(told = std::move(names));
    const Status published = topics.publish(live.set);
    if (!published && options.log && !std::exchange(reported, true))
      options.log(LogLevel::kWarning, published.error().message);
    if (!live.set.frames.empty()) times.add(SteadyClock().now() - arrived);
  }
  times.tell(options.log);
  return {};
}

}  // namespace roomcast::ros2
