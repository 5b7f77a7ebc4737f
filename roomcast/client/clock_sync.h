// SPDX-License-Identifier: Apache-2.0
// ClockSync: where room time (the hub's monotonic clock) stands against this host's, and how fast
// the two drift apart.
//
//   1. A ping that left at `sent` and came back at `received`, read by the hub at `hub`, says that
//      room time is ahead by hub - (sent + received) / 2, give or take half of its round trip.
//   2. Who waited behind a frame on its way says little, and nobody knows in which direction it is
//      wrong: the quickest of recent exchanges is believed.
//   3. The quickest of every kWindow exchanges is kept for a minute or so; the slope through those
//      that hardly waited is the drift.
//   4. Exchanges that contradict the believed one by more than either can have waited mean that a
//      clock was set or stood still (a suspended computer). After kWitnesses of them everything
//      starts anew.
//
// Sources: Cristian 1989 (1); the minimum filter of NTP, RFC 5905 section 10 (2); the slope is the
// median of all slopes between two points, Theil 1950 and Sen 1968: a few bad points do not move it
// (3). docs/spec/wire.md section 3, "Clock". A way that is always slower in one direction than in
// the other cannot be seen from here; half of the difference is an error that stays. Pure.
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
  static constexpr std::size_t kWitnesses = 3;
  static constexpr double kLargestDrift = 100e-6;     // of two quartz clocks
  static constexpr double kDriftUncertainty = 10e-6;  // once it has been measured
  /// Two exchanges that did not wait agree to this much: what programs need to wake up.
  static constexpr nanoseconds kAgreement{500'000};
  static constexpr nanoseconds kFarthest{std::int64_t{1} << 60};  // 36 years; no clock shows more

  /// A ping left at `sent`, the hub read it at `hub`, its answer came at `received`; in the order
  /// of `received`. An answer from before its question is ignored, and so are times that no clock
  /// shows.
  void add(HostTime sent, RoomTime hub, HostTime received);

  /// Nothing before the first exchange.
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
  [[nodiscard]] bool contradicts_what_is_believed(const Exchange& exchange) const;

  std::deque<Exchange> window_;   // newest last, at most kWindow
  std::deque<Exchange> history_;  // the quickest of each full window, at most kHistory
  std::size_t since_remembered_ = 0;
  std::optional<double> drift_;
  std::deque<Exchange> witnesses_;  // of a clock that was set
};

}  // namespace roomcast::client
