// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/room_bridge.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/recording/live_sets/live_sets.h"

namespace roomcast::ros2 {
namespace {

constexpr std::chrono::milliseconds kLook{100};  // for the end, without news of the room

constexpr std::size_t kMaxTimes = 100'000;  // an hour at 30 sets a second

/// The processor's time that this thread has used.
nanoseconds used_by_thread() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds(used.tv_sec) + nanoseconds(used.tv_nsec);
}

/// How long sets take from their arrival until they are handed to DDS, and how long the processor
/// works for them; the rest is waiting for a processor.
class BridgeTimes {
 public:
  void begin() {
    arrived_ = SteadyClock().now();
    used_before_ = used_by_thread();
  }
  void end() {
    if (passed_.size() == kMaxTimes) return;
    passed_.push_back(SteadyClock().now() - arrived_);
    used_.push_back(used_by_thread() - used_before_);
  }
  void tell(const LogSink& log) {
    if (!log || passed_.empty()) return;
    log(LogLevel::kInfo,
        std::to_string(passed_.size()) + " frame sets: half were published within " +
            ms_of(passed_, 0.5) + " ms of their arrival, 99 in 100 within " + ms_of(passed_, 0.99) +
            " ms; the processor took " + ms_of(used_, 0.5) + " and " + ms_of(used_, 0.99) + " ms");
  }

 private:
  static std::string ms_of(std::vector<nanoseconds>& times, double share) {
    const auto place =
        times.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times.size() - 1));
    std::nth_element(times.begin(), place, times.end());
    std::string text = std::to_string(std::chrono::duration<double, std::milli>(*place).count());
    return text.substr(0, text.find('.') + 3);
  }
  HostTime arrived_{};
  nanoseconds used_before_{};
  std::vector<nanoseconds> passed_, used_;
};

}  // namespace

Status bridge_room(const client::Subscriber& room, RoomTopics& topics,
                   const RoomBridgeOptions& options, const std::stop_token& stop) {
  recording::LiveSets sets;
  std::uint64_t revision = 0, told = 0;
  BridgeTimes times;
  bool reported = false;  // a message that cannot be sent; once is enough
  while (!stop.stop_requested()) {
    if (auto failure = room.failure()) return *failure;
    const auto snapshot = room.wait_newer(revision, kLook);
    if (snapshot->revision == revision) continue;
    revision = snapshot->revision;
    times.begin();
    if (!snapshot->connected) continue;
    if (Status status = client::check_may_export(snapshot->rights); !status) return status;
    const recording::LiveSet live = sets.set_of(*snapshot);
    if (Status status = topics.set_sensors(live.sensors); !status) return status;
    if (options.on_topics && topics.changes() != told) {
      told = topics.changes();
      options.on_topics(topics.names());
    }
    const Status published = topics.publish(live.set);
    if (!published && options.log && !std::exchange(reported, true))
      options.log(LogLevel::kWarning, published.error().message);
    if (!live.set.frames.empty()) times.end();
  }
  times.tell(options.log);
  return {};
}

}  // namespace roomcast::ros2
