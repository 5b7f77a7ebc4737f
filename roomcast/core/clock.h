// SPDX-License-Identifier: Apache-2.0
// Time. Code that measures time asks a Clock, so that tests can control it. Host time is this
// machine's monotonic clock; room time is the hub's. Both are int64 nanoseconds.
#pragma once

#include <chrono>
#include <cstdint>

namespace roomcast {

using std::chrono::nanoseconds;

/// Instants of this machine's monotonic clock (CLOCK_MONOTONIC: shared by all processes of a host).
struct HostClockTag {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = nanoseconds;
  using time_point = std::chrono::time_point<HostClockTag, nanoseconds>;
  static constexpr bool is_steady = true;
};
using HostTime = HostClockTag::time_point;

/// Instants of the hub's monotonic clock. A client knows it only as HostTime plus an estimated
/// offset.
struct RoomClockTag {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = nanoseconds;
  using time_point = std::chrono::time_point<RoomClockTag, nanoseconds>;
  static constexpr bool is_steady = true;
};
using RoomTime = RoomClockTag::time_point;

/// Thread-safe.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual HostTime now() const = 0;
};

class SteadyClock final : public Clock {
 public:
  [[nodiscard]] HostTime now() const override {
    return HostTime(std::chrono::steady_clock::now().time_since_epoch());
  }
};

/// Advances only by advance(). For tests; single-threaded.
class FakeClock final : public Clock {
 public:
  [[nodiscard]] HostTime now() const override { return now_; }
  void advance(nanoseconds by) { now_ += by; }

 private:
  HostTime now_{};
};

}  // namespace roomcast
