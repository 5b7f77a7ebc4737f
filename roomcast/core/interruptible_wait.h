// SPDX-License-Identifier: Apache-2.0
// Waits that end early when the thread is asked to stop. Thread-safe (no state).
#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>

#include "roomcast/core/clock.h"

namespace roomcast {

/// False if `stop` was requested first.
inline bool wait_until(HostTime time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  const std::chrono::steady_clock::time_point due(time.time_since_epoch());
  never.wait_until(lock, stop, due, [] { return false; });
  return !stop.stop_requested();
}

/// False if `stop` was requested first.
inline bool wait_for(nanoseconds time, const std::stop_token& stop) {
  return wait_until(SteadyClock().now() + time, stop);
}

}  // namespace roomcast
