// SPDX-License-Identifier: Apache-2.0
// ClockSync: estimates the offset of room time (the hub's monotonic clock) from this host's clock,
// and the drift between the two.
//
//   1. A ping that left at `sent`, was read by the hub at `hub` and was answered at `received`
//      shows that room time is ahead by hub - (sent + received) / 2, plus or minus half of its
//      round trip.
//   2. An exchange that waited behind a frame has a large error of unknown sign: the recent
//      exchange with the shortest round trip is used.
//   3. The shortest of every kWindow exchanges is kept for a minute or so; the slope through those
//      that hardly waited is the drift.
//   4. Exchanges that contradict the estimate by more than their waiting can explain mean that a
//      clock was set or was stopped (a suspended computer). After kOutliersToReset of them the
//      estimate is reset.
//
// Sources: Cristian 1989 (1); the minimum filter of NTP, RFC 5905 section 10 (2); the slope is the
// median of all slopes between two points, Theil 1950 and Sen 1968, which is robust against a few
// outliers (3). docs/spec/wire.md section 3, "Clock". A constant asymmetry of the two directions
// cannot be measured here; half of the difference remains as an error. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/core/clock.h"

namespace roomcast::client {

class ClockSync {
 public:
  static constexpr std::size_t kWindow = 32;   // exchanges
  static constexpr std::size_t kHistory = 20;  // windows
  static constexpr std::size_t kFewestForDrift = 5;
  static constexpr std::size_t kOutliersToReset = 3;
  static constexpr double kLargestDrift = 100e-6;     // between two quartz clocks
  static constexpr double kDriftUncertainty = 10e-6;  // once the drift has been measured
  /// Two exchanges without waiting agree within this time: the time programs need to wake up.
  static constexpr nanoseconds kAgreement{500'000};
  static constexpr nanoseconds kFarthest{std::int64_t{1} << 60};  // larger times are invalid

  /// Adds an exchange: a ping left at `sent`, the hub read it at `hub`, the answer came at
  /// `received`; in the order of `received`. An answer that precedes its ping is ignored, and so
  /// are times beyond kFarthest.
  void add(HostTime sent, RoomTime hub, HostTime received);

  /// The estimate at the newest exchange; nothing before the first one.
  [[nodiscard]] std::optional<ClockEstimate> estimate() const;

 private:
  struct Exchange {
    HostTime received{};
    nanoseconds round_trip{};
    nanoseconds room_minus_host{};
  };

  void take(const Exchange& exchange);
  void remember_quickest_of_window();
  [[nodiscard]] std::optional<double> measured_drift() const;
  [[nodiscard]] double drift_uncertainty() const;
  [[nodiscard]] nanoseconds error_of(const Exchange& exchange, HostTime now) const;
  [[nodiscard]] const Exchange& believed(HostTime now) const;
  [[nodiscard]] ClockEstimate estimate_at(HostTime now) const;
  [[nodiscard]] std::vector<nanoseconds> round_trips() const;
  [[nodiscard]] nanoseconds least_round_trip(const Exchange& newest) const;
  [[nodiscard]] bool contradicts_estimate(const Exchange& exchange) const;

  std::deque<Exchange> window_;   // newest last, at most kWindow
  std::deque<Exchange> history_;  // the shortest round trip of each full window, at most kHistory
  std::size_t since_remembered_ = 0;
  std::optional<double> drift_;
  std::deque<Exchange> witnesses_;  // exchanges that contradict the estimate
};

}  // namespace roomcast::client
