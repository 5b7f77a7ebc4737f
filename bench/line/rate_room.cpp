// SPDX-License-Identifier: Apache-2.0
#include "bench/line/rate_room.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "bench/line/looped_source.h"
#include "roomcast/client/subscriber.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kFps = 15;  // what this machine can register and encode for several sensors
constexpr int kLoopFrames = 45;
constexpr auto kReadEvery = 10ms;  // the link's counter
constexpr auto kPoseEvery = 50ms, kTurnEvery = 4'000ms;
constexpr double kHalfAngle_rad = 0.6;

}  // namespace

Result<std::unique_ptr<RateRoom>> RateRoom::open(const LineBenchOptions& options,
                                                 const LinkSpec& link,
                                                 const sensor::CodecChoice& codec,
                                                 double uplink_mbit, End hub_at) {
  auto emulated = EmulatedLink::open(link);
  if (!emulated) return emulated.error();
  std::unique_ptr<RateRoom> room(new RateRoom(*std::move(emulated)));
  Status status;
  room->link_->run(hub_at, [&] { status = room->open_hub(uplink_mbit, hub_at); });
  if (!status) return status.error();
  room->link_->run(End::kFar,
                   [&] { room->watcher_ = std::make_unique<SetWatcher>(room->hub_->url()); });
  for (int i = 0; i < options.sensors; ++i)
    if (status = room->join_sensor(options, codec, i); !status) return status.error();
  return room;
}

RateOutcome RateRoom::measure(std::chrono::milliseconds duration) {
  (void)watcher_->take();
  RateOutcome outcome = read_line(duration);
  Arrivals arrivals = watcher_->take();
  outcome.ages_ms = std::move(arrivals.ages_ms);
  outcome.small_frames = arrivals.small_frames;
  std::size_t most_frames = 0;
  for (const auto& [sensor, times_ms] : arrivals.times_ms) {
    double longest_gap_ms = 0;
    for (std::size_t i = 1; i < times_ms.size(); ++i)
      longest_gap_ms = std::max(longest_gap_ms, times_ms[i] - times_ms[i - 1]);
    outcome.longest_gap_ms = std::max(outcome.longest_gap_ms, longest_gap_ms);
    if (times_ms.size() <= most_frames) continue;
    most_frames = times_ms.size();
    outcome.best_sensor = {static_cast<double>(most_frames), longest_gap_ms};
  }
  return outcome;
}

Result<RateOutcome> RateRoom::measure_turning(std::chrono::milliseconds duration) {
  std::unique_ptr<client::Subscriber> viewer;
  Status status;
  link_->run(End::kFar, [&] {
    auto opened =
        client::Subscriber::open({.hub_url = hub_->url(), .room = {}, .name = {}, .log = {}});
    if (opened)
      viewer = *std::move(opened);
    else
      status = opened.error();
  });
  if (!status) return status.error();
  watcher_.reset();  // it wants everything
  const std::jthread turning([&viewer](const std::stop_token& stop) {
    for (int step = 0; !stop.stop_requested(); ++step) {
      client::PersonPose pose;
      const bool is_back = step * kPoseEvery / kTurnEvery % 2 == 1;
      pose.world_from_head.translation_m = {0, 1.6, 0};
      if (is_back) pose.world_from_head.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
      pose.view.half_angle_rad = kHalfAngle_rad;
      viewer->send_pose(pose);
      std::this_thread::sleep_for(kPoseEvery);
    }
  });
  std::this_thread::sleep_for(2 * kTurnEvery);
  return read_line(duration);
}

RateOutcome RateRoom::read_line(std::chrono::milliseconds duration) {
  RateOutcome outcome;
  const auto began = std::chrono::steady_clock::now();
  for (auto now = began; now < began + duration; now = std::chrono::steady_clock::now()) {
    outcome.line.add(now, link_->carried_bytes(), has_more_to_send());
    std::this_thread::sleep_for(kReadEvery);
  }
  outcome.seconds = std::chrono::duration<double>(duration).count();
  return outcome;
}

/// Not all sensors send their finest quality.
bool RateRoom::has_more_to_send() const {
  return !std::ranges::all_of(feeds_,
                              [](const auto& feed) { return feed->stats().has_finest_quality; });
}

Status RateRoom::open_hub(double uplink_mbit, End end) {
  hub::RoomSettings settings;
  settings.uplink_mbit = uplink_mbit;
  auto hub = hub::RunningHub::start(
      {.address = EmulatedLink::address(end), .port = 0, .rooms = {settings}});
  if (!hub) return hub.error();
  hub_ = *std::move(hub);
  return {};
}

Status RateRoom::join_sensor(const LineBenchOptions& options, const sensor::CodecChoice& codec,
                             int number) {
  auto source = LoopedSource::capture(options.scene, number, options.sensors, kFps, kLoopFrames);
  if (!source) return source.error();
  sensor::SensorFeedOptions feed;
  feed.hub_url = hub_->url();
  feed.codec = codec;
  Status status;
  link_->run(End::kNear, [&] {
    auto started = sensor::SensorFeed::start(*std::move(source), feed);
    if (started)
      feeds_.push_back(*std::move(started));
    else
      status = started.error();
  });
  return status;
}

std::vector<double> RateRoom::bytes_sent() const {
  std::vector<double> bytes;
  for (const auto& feed : feeds_) bytes.push_back(static_cast<double>(feed->stats().bytes_sent));
  return bytes;
}

}  // namespace roomcast::bench
