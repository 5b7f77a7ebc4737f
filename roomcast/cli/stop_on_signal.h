// SPDX-License-Identifier: Apache-2.0
// StopOnSignal: Ctrl-C and SIGTERM become a stop token. Make it before any other thread, so that
// all threads leave these signals to it.
#pragma once

#include <stop_token>
#include <thread>

namespace roomcast::cli {

class StopOnSignal {
 public:
  StopOnSignal();
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
