// SPDX-License-Identifier: Apache-2.0
// StopNotice: wakes a thread that waits for a hub's answer when the program is asked to end.
// Threading: lives on the waiting thread, which does not hold `mutex` when it is made or destroyed.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>

#include "roomcast/core/result.h"

namespace roomcast::client {

class StopNotice {
 public:
  StopNotice(const std::stop_token& stop, std::mutex& mutex, std::condition_variable& changed)
      : callback_(stop, [&mutex, &changed] {
          const std::lock_guard lock(mutex);
          changed.notify_all();
        }) {}

 private:
  std::stop_callback<std::function<void()>> callback_;
};

[[nodiscard]] inline Error stopped_waiting() {
  return {ErrorCode::kClosed, "stopped before the hub had answered"};
}

}  // namespace roomcast::client
