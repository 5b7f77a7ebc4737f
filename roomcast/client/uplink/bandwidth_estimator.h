// SPDX-License-Identifier: Apache-2.0
// BandwidthEstimator: finds the rate that a sender may use on its line, out of what its own TCP
// delivers. While bytes wait without a break, the line is full, and what it delivers is what it
// can: if that is less than the rate, the rate is cut below it, so that what waits can leave.
// The same where a queue of the line stands, which senders that share the line keep full together.
// Otherwise the rate grows: fast at first, carefully near the last rate that was too high, faster
// beyond it, and slower the longer the queue is. An interruption is no sign of a slower line, and
// losses without a queue are a weak one. Pure; time is an argument. Single-threaded. Sources:
// capacity as the delivery rate while the sender is not limited by itself, as in BBR (Cardwell et
// al. 2016); growth by the distance to the last capacity, as in CUBIC (RFC 9438); a constant added
// to all, by which senders on one line come to equal rates (Chiu and Jain 1989); a queue's delay as
// a sign before losses, as in TCP Vegas (Brakmo and Peterson 1995).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::client {

class BandwidthEstimator {
 public:
  static constexpr double kStart = 1e6 / 8;  // bytes/s, until more is known
  static constexpr double kMin = 0.1e6 / 8, kMax = 100e6 / 8;

  /// The kernel's counters at one moment.
  struct Reading {
    HostTime time{};
    std::uint64_t delivered_bytes = 0;  // since the connection began
    bool is_waiting = false;            // there are bytes that are not sent yet
    nanoseconds round_trip{};
    double bbr_bytes_per_s = 0;  // 0: unknown
    bool is_probing_round_trip = false;
    std::uint64_t resent_packets = 0;  // since the connection began
  };
  /// Call every 20 ms or so; a gap of half a second begins anew what was being observed.
  void add(const Reading& reading);

  /// The rate to send at, kMin..kMax.
  [[nodiscard]] double bytes_per_s() const { return rate_; }

  /// Of the line's queue, by the newest reading: 1 where nothing waits there, 0 where bytes wait
  /// longer than those of other senders' frames would.
  [[nodiscard]] double room() const { return room_; }

  /// At which to send what waits, bytes/s: `margin` times the rate while nothing waits in the
  /// line's queue, the rate itself where the queue has no room.
  [[nodiscard]] double pace(double margin) const { return rate_ * (1 + room_ * (margin - 1)); }

 private:
  struct Moment {
    HostTime time{};
    std::uint64_t delivered_bytes = 0, resent_packets = 0;
    nanoseconds round_trip{};
    double rate = 0;
  };

  void observe(const Reading& reading);
  [[nodiscard]] std::optional<double> overload(const Reading& reading) const;
  void cut(double delivered_per_s, HostTime now);
  [[nodiscard]] bool drain(const Reading& reading);
  [[nodiscard]] nanoseconds standing_queue(const Reading& reading, nanoseconds look) const;
  void grow(const Reading& reading, double seconds);
  [[nodiscard]] double growth_per_s(double seconds);
  [[nodiscard]] double careful_growth_per_s() const;
  [[nodiscard]] double used_share(const Reading& reading) const;
  [[nodiscard]] nanoseconds longest_passing_queue() const;
  [[nodiscard]] double room_in_queue(const Reading& reading) const;
  [[nodiscard]] double rate_before(HostTime time) const;
  [[nodiscard]] bool has_resent_since(HostTime begin, const Reading& reading) const;
  [[nodiscard]] double best_part_since(HostTime begin, const Reading& reading) const;
  [[nodiscard]] double delivered_since(HostTime begin, const Reading& reading) const;

  double rate_ = kStart;
  double capacity_ = 0;         // the line's rate when it was last full; 0: it never was
  double room_ = 1;             // of its queue
  double growth_ = 0;           // per second, as a logarithm
  std::deque<Moment> moments_;  // of the last seconds
  std::optional<HostTime> full_since_;
  HostTime last_arrival_{};
  HostTime next_cut_{}, next_drain_{};
  nanoseconds least_round_trip_{nanoseconds::max()};
};

}  // namespace roomcast::client
