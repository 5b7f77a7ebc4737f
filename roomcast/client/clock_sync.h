// SPDX-License-Identifier: Apache-2.0
// ClockSync: where room time (the hub's monotonic clock) stands against this host's. Of the last
// kWindow exchanges the one with the shortest round trip is believed: the others waited somewhere
// on their way, and nobody knows in which direction. Half of that round trip bounds the error.
// Source: Cristian 1989; the minimum filter as in NTP (RFC 5905 §10). docs/spec/wire.md §3,
// "Clock". Pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast {

struct ClockEstimate {
  nanoseconds room_minus_host{};
  nanoseconds error{};  // bound, if the clocks run equally fast

  [[nodiscard]] RoomTime room_time(HostTime host) const {
    return RoomTime(host.time_since_epoch() + room_minus_host);
  }
};

class ClockSync {
 public:
  static constexpr std::size_t kWindow = 32;

  /// A ping left at `sent`, the hub read it at `hub`, its answer came at `received`. An answer from
  /// before its question is ignored.
  void add(HostTime sent, RoomTime hub, HostTime received);

  /// Nothing before the first exchange.
  [[nodiscard]] std::optional<ClockEstimate> estimate() const;

 private:
  struct Exchange {
    nanoseconds round_trip{};
    nanoseconds room_minus_host{};
  };
  std::array<Exchange, kWindow> exchanges_{};
  std::size_t count_ = 0;  // ever added
};

}  // namespace roomcast
