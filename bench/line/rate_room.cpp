// SPDX-License-Identifier: Apache-2.0
#include "bench/line/rate_room.h"

#include <thread>
#include <utility>

#include "bench/line/looped_source.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kFps = 15;  // what this machine can register and encode for several sensors
constexpr int kLoopFrames = 45;
constexpr auto kReadEvery = 10ms;  // the link's counter

}  // namespace

Result<std::unique_ptr<RateRoom>> RateRoom::open(const LineBenchOptions& options,
                                                 const LinkSpec& link,
                                                 const sensor::CodecChoice& codec) {
  auto emulated = EmulatedLink::open(link);
  if (!emulated) return emulated.error();
  std::unique_ptr<RateRoom> room(new RateRoom(*std::move(emulated)));
  Status status;
  room->link_->run(EmulatedLink::End::kFar, [&] { status = room->enter_far(); });
  if (!status) return status.error();
  room->link_->run(EmulatedLink::End::kNear, [&] { status = room->enter_near(options, codec); });
  if (!status) return status.error();
  return room;
}

RateOutcome RateRoom::measure(std::chrono::milliseconds duration) {
  RateOutcome outcome;
  (void)watcher_->take();
  const auto began = std::chrono::steady_clock::now();
  for (auto now = began; now < began + duration; now = std::chrono::steady_clock::now()) {
    outcome.line.add(now, link_->carried_bytes());
    std::this_thread::sleep_for(kReadEvery);
  }
  outcome.ages_ms = watcher_->take().ages_ms;
  outcome.seconds = std::chrono::duration<double>(duration).count();
  return outcome;
}

Status RateRoom::enter_far() {
  auto hub = hub::RunningHub::start(
      {.address = EmulatedLink::address(EmulatedLink::End::kFar), .port = 0});
  if (!hub) return hub.error();
  hub_ = *std::move(hub);
  watcher_ = std::make_unique<SetWatcher>(hub_->url());
  return {};
}

Status RateRoom::enter_near(const LineBenchOptions& options, const sensor::CodecChoice& codec) {
  for (int i = 0; i < options.sensors; ++i) {
    auto source = LoopedSource::capture(options.scene, i, options.sensors, kFps, kLoopFrames);
    if (!source) return source.error();
    sensor::SensorFeedOptions feed;
    feed.hub_url = hub_->url();
    feed.codec = codec;
    auto started = sensor::SensorFeed::start(*std::move(source), feed);
    if (!started) return started.error();
    feeds_.push_back(*std::move(started));
  }
  return {};
}

}  // namespace roomcast::bench
