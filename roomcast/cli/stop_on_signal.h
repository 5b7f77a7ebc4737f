// SPDX-License-Identifier: Apache-2.0
// StopOnSignal: Ctrl-C and SIGTERM become a stop token. Make it before any other thread, so that
// all threads leave these signals to it.
#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace roomcast::cli {

class StopOnSignal {
 public:
  /// `on_hangup`: what SIGHUP does instead of stopping; on a thread of its own. Nothing: it stops.
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
