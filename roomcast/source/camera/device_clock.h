// SPDX-License-Identifier: Apache-2.0
// DeviceClock: when a picture was taken, on this host's clock. Pictures arrive late by a delay that
// jitters (USB, decoding); a camera's own clock does not jitter but runs from another start at
// another rate. The smallest arrival - device time of the last seconds is what the fastest picture
// took, and tells the offset (minimum filtering: Moon, Skelly & Towsley 1999). What even the
// fastest takes remains unknown: some milliseconds. Single-threaded.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::source {

class DeviceClock {
 public:
  /// Clocks drift by less than a millisecond in this time.
  static constexpr std::chrono::seconds kWindow{5};
  /// A device time that is off by more means that the clock was set anew.
  static constexpr std::chrono::seconds kLeap{1};

  /// Never later than `arrived`.
  [[nodiscard]] HostTime capture_time(nanoseconds device_time, HostTime arrived);

 private:
  void begin_window(HostTime arrived, nanoseconds delay);

  HostTime window_began_{};
  std::optional<nanoseconds> smallest_;  // in this window
  std::optional<nanoseconds> before_;    // in the one before
};

/// A counter of `bits` bits that wraps around, made to grow for ever.
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
