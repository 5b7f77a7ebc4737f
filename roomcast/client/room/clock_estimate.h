// SPDX-License-Identifier: Apache-2.0
// A client's estimate of room time, the hub's monotonic clock (estimated by client/clock_sync.h).
#pragma once

#include <cstdint>

#include "roomcast/core/clock.h"

namespace roomcast::client {

struct ClockEstimate {
  HostTime at{};                  // time of the newest exchange
  nanoseconds room_minus_host{};  // offset at that time
  double drift = 0;               // by how much the room's clock runs faster; 1e-6 is 1 ppm
  nanoseconds error{};            // bound on room_minus_host

  [[nodiscard]] RoomTime room_time(HostTime host) const {
    return RoomTime(host.time_since_epoch() + room_minus_host + drifted(host - at));
  }
  [[nodiscard]] nanoseconds drifted(nanoseconds in) const {
    return nanoseconds(static_cast<std::int64_t>(drift * static_cast<double>(in.count())));
  }
};

}  // namespace roomcast::client
