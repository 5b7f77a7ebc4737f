// SPDX-License-Identifier: Apache-2.0
// ProcessorLoad: the number of processor cores that this process uses, averaged over about the last
// second. Source: getrusage(2). Single-threaded.
#pragma once

#include <sys/resource.h>

#include "roomcast/core/clock.h"

namespace roomcast::hub::federation {

class ProcessorLoad {
 public:
  static constexpr std::chrono::seconds kOver{1};

  void sample(HostTime now) {
    if (now - since_ < kOver) return;
    const nanoseconds used = used_so_far();
    cores_ =
        static_cast<float>((used - used_).count()) / static_cast<float>((now - since_).count());
    since_ = now;
    used_ = used;
  }
  [[nodiscard]] float cores() const { return cores_; }

 private:
  static nanoseconds used_so_far() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto of = [](const timeval& time) {
      return std::chrono::seconds(time.tv_sec) + std::chrono::microseconds(time.tv_usec);
    };
    return of(usage.ru_utime) + of(usage.ru_stime);
  }

  HostTime since_{};
  nanoseconds used_{};
  float cores_ = 0;
};

}  // namespace roomcast::hub::federation
