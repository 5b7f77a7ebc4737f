// SPDX-License-Identifier: Apache-2.0
// UnixClock: time of day for stamping recordings. It is read once and then advances with the steady
// clock, so later changes of the machine's clock have no effect. Thread-safe.
#pragma once

#include <chrono>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/core/clock.h"

namespace roomcast::recording {

class UnixClock {
 public:
  /// Time since 1970-01-01 00:00 UTC.
  [[nodiscard]] nanoseconds at(HostTime host) const {
    return host.time_since_epoch() + unix_minus_host_;
  }
  /// The same of a time of a room, as well as its clock is known.
  [[nodiscard]] nanoseconds at(RoomTime room, const client::ClockEstimate& clock) const {
    const HostTime about(room.time_since_epoch() - clock.room_minus_host);
    return at(about - clock.drifted(about - clock.at));
  }
  [[nodiscard]] nanoseconds now() const { return at(SteadyClock().now()); }

 private:
  nanoseconds unix_minus_host_ =
      std::chrono::system_clock::now().time_since_epoch() - SteadyClock().now().time_since_epoch();
};

}  // namespace roomcast::recording
