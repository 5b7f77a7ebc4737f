// SPDX-License-Identifier: Apache-2.0
// MotionFollower: follows a room and finds how what it shows moves. That takes 4 to 8 ms for a
// picture with somebody near, too long for the thread that draws. Threading: has its own thread;
// thread-safe.
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "roomcast/client/subscriber.h"
#include "roomcast/viewer/motion/room_motion.h"

namespace roomcast::viewer {

class MotionFollower {
 public:
  /// `hub` must outlive it.
  explicit MotionFollower(const client::Subscriber& hub);

  struct Moment {
    std::shared_ptr<const client::RoomSnapshot> room;  // never null
    RoomMotion motion;                                 // of its pictures
  };
  /// Of the newest snapshot whose motion is known. Never null; does not wait.
  [[nodiscard]] std::shared_ptr<const Moment> newest() const;

 private:
  void follow(const std::stop_token& stop);

  const client::Subscriber& hub_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Moment> newest_;
  std::jthread thread_;  // last: uses all of the above
};

}  // namespace roomcast::viewer
