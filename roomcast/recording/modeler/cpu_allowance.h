// SPDX-License-Identifier: Apache-2.0
// CpuAllowance: keeps work that comes now and then below a share of a core's time. Time that was
// not used is saved for a while, so that after a calm time one piece of work may follow the other
// at once. Counted in CPU time: on a busy machine work that takes long is not more work. Pure;
// single-threaded. Source: the token bucket.
#pragma once

#include <algorithm>
#include <chrono>

#include "roomcast/core/clock.h"

namespace roomcast::recording {

struct CpuAllowanceOptions {
  int time_per_work = 3;  // a third of a core
  nanoseconds max_saved = std::chrono::seconds(10);
};

class CpuAllowance {
 public:
  explicit CpuAllowance(const CpuAllowanceOptions& options = {}) : options_(options) {}

  /// When work may begin again.
  [[nodiscard]] HostTime next() const { return next_; }
  /// Work has ended that took so much CPU time.
  void spent(nanoseconds cpu_time, HostTime now) {
    next_ = std::max(next_, now - options_.max_saved) + options_.time_per_work * cpu_time;
  }

 private:
  CpuAllowanceOptions options_;
  HostTime next_{};
};

}  // namespace roomcast::recording
