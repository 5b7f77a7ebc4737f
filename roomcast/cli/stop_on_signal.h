// SPDX-License-Identifier: Apache-2.0
// StopOnSignal: turns Ctrl-C and SIGTERM into a stop token. Construct it before starting any other
// thread, so that all threads inherit the blocked signals.
#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace roomcast::cli {

class StopOnSignal {
 public:
  /// `on_hangup` runs, on a thread of its own, when SIGHUP arrives. If empty, SIGHUP stops as well.
  explicit StopOnSignal(std::function<void()> on_hangup = {});
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  void request_stop() { stop_.request_stop(); }

 private:
  std::stop_source stop_;
  std::jthread waiter_;
};

}  // namespace roomcast::cli
