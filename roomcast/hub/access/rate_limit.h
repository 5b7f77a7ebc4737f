// SPDX-License-Identifier: Apache-2.0
// RateLimit: limits a rate per second and the size of bursts (a token bucket). Pure;
// single-threaded. Source: RFC 2697 describes the meter.
#pragma once

#include <algorithm>
#include <chrono>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

class RateLimit {
 public:
  /// `burst`: the amount allowed at once.
  RateLimit(double per_second, double burst)
      : per_second_(per_second), burst_(burst), left_(burst) {}

  /// False: the limit is exceeded.
  [[nodiscard]] bool take(double amount, HostTime now) {
    if (last_ != HostTime{}) {
      const double passed_s = std::chrono::duration<double>(now - last_).count();
      left_ = std::min(burst_, left_ + per_second_ * passed_s);
    }
    last_ = now;
    left_ -= amount;
    return left_ >= 0;
  }

 private:
  double per_second_, burst_, left_;
  HostTime last_{};
};

}  // namespace roomcast::hub
