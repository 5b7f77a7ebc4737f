// SPDX-License-Identifier: Apache-2.0
// DeviceClock: converts a picture's device time to this host's clock. Pictures arrive with a
// jittering delay (USB, decoding); a camera's own clock does not jitter but has another origin and
// another rate. The smallest difference of arrival and device time in the last seconds belongs to
// the fastest picture and gives the offset (minimum filtering: Moon, Skelly & Towsley 1999). The
// delay of the fastest picture stays unknown: some milliseconds. Single-threaded.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::source {

class DeviceClock {
 public:
  /// Clocks drift by less than a millisecond in this time.
  static constexpr std::chrono::seconds kWindow{5};
  /// A device time that is off by more means that the clock was reset.
  static constexpr std::chrono::seconds kLeap{1};

  /// Never later than `arrived`.
  [[nodiscard]] HostTime capture_time(nanoseconds device_time, HostTime arrived);

 private:
  void begin_window(HostTime arrived, nanoseconds delay);

  HostTime window_began_{};
  std::optional<nanoseconds> smallest_;  // in the current window
  std::optional<nanoseconds> before_;    // in the previous window
};

/// Extends a wrapping counter of `bits` bits to a growing time.
class TickCounter {
 public:
  TickCounter(int bits, double ticks_per_second);
  [[nodiscard]] nanoseconds time(std::uint64_t ticks);

 private:
  const std::uint64_t mask_;
  const double nanoseconds_per_tick_;
  std::optional<std::uint64_t> last_;
  std::uint64_t total_ = 0;
};

}  // namespace roomcast::source
