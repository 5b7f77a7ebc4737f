// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/motion/motion_follower.h"

#include <chrono>
#include <utility>

namespace roomcast::viewer {
namespace {

constexpr std::chrono::milliseconds kCheckForStop{50};

}  // namespace

MotionFollower::MotionFollower(const client::Subscriber& hub)
    : hub_(hub),
      newest_(std::make_shared<const Moment>(hub.snapshot())),
      thread_([this](const std::stop_token& stop) { follow(stop); }) {}

std::shared_ptr<const MotionFollower::Moment> MotionFollower::newest() const {
  std::lock_guard lock(mutex_);
  return newest_;
}

/// Until it is stopped, or the connection has ended for good: then there is nothing new.
void MotionFollower::follow(const std::stop_token& stop) {
  MotionFinder finder;
  std::uint64_t revision = newest()->room->revision;
  while (!stop.stop_requested()) {
    const bool is_over = hub_.failure().has_value();
    auto room = hub_.wait_newer(revision, kCheckForStop);
    if (room->revision != revision) {
      revision = room->revision;
      RoomMotion motion = finder.find(*room);
      auto moment = std::make_shared<const Moment>(std::move(room), std::move(motion));
      std::lock_guard lock(mutex_);
      newest_ = std::move(moment);
    } else if (is_over) {
      return;
    }
  }
}

}  // namespace roomcast::viewer
