// SPDX-License-Identifier: Apache-2.0
// Measures CPU time of the calling thread, so that other programs on the machine do not count.
// Starts on construction.
#pragma once

#include <ctime>

namespace roomcast::bench {

class CpuStopwatch {
 public:
  CpuStopwatch() : start_ms_(now_ms()) {}
  [[nodiscard]] double ms() const { return now_ms() - start_ms_; }

 private:
  static double now_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
  }
  double start_ms_;
};

}  // namespace roomcast::bench
