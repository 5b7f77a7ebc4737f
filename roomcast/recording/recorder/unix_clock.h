// SPDX-License-Identifier: Apache-2.0
// The time of day as this program believes it to be: read once, then it goes on evenly, whatever
// happens to the machine's clock. Recordings are stamped with it. Thread-safe.
#pragma once

#include <chrono>

#include "roomcast/core/clock.h"

namespace roomcast::recording {

class UnixClock {
 public:
  /// Since 1970-01-01 00:00 UTC.
  [[nodiscard]] nanoseconds at(HostTime host) const {
    return host.time_since_epoch() + unix_minus_host_;
  }
  [[nodiscard]] nanoseconds now() const { return at(SteadyClock().now()); }

 private:
  nanoseconds unix_minus_host_ =
      std::chrono::system_clock::now().time_since_epoch() - SteadyClock().now().time_since_epoch();
};

}  // namespace roomcast::recording
