// SPDX-License-Identifier: Apache-2.0
// PingSchedule: the time between two clock pings of a client. The first few pings are close
// together, for a quick estimate; later ones come at random intervals, because frames come at
// regular ones, and a ping in phase with them would wait behind a frame every time (measured: 6.9
// ms wrong instead of 7 us). docs/spec/wire.md section 3, "Clock". No I/O.
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace roomcast::client {

class PingSchedule {
 public:
  struct Rhythm {
    int quick;                          // initial pings, one every kQuickPing
    std::chrono::milliseconds average;  // mean interval of the later pings
    int settling;  // before that, pings with a mean interval of kSettling, up to this count
  };
  static constexpr std::chrono::milliseconds kQuickPing{20}, kSettling{100};
  static constexpr double kSpread = 0.7;  // of the mean interval, in either direction

  /// ClockSync needs 160 pings to measure the drift. Sensors, which time-stamp frames, need the
  /// time to microseconds; viewers do not.
  static constexpr Rhythm kOfSensor{.quick = 5, .average = kSettling, .settling = 0};
  static constexpr Rhythm kOfViewer{
      .quick = 5, .average = std::chrono::milliseconds(500), .settling = 160};
  /// A relaying hub connects anew for every viewer, and each ping wakes this hub twice and the
  /// other hub once, which costs more than a set of frames. In two seconds the clocks drift apart
  /// by no more than 0.2 ms.
  static constexpr Rhythm kOfHub{
      .quick = 32, .average = std::chrono::milliseconds(2000), .settling = 0};

  PingSchedule(const Rhythm& rhythm, std::uint32_t seed) : rhythm_(rhythm), random_(seed) {}

  /// A new connection: start with the quick pings again.
  void start_anew() { pings_ = 0; }

  [[nodiscard]] std::chrono::nanoseconds next() {
    const int ping = pings_++;
    if (ping < rhythm_.quick) return kQuickPing;
    std::uniform_real_distribution<double> share(1 - kSpread, 1 + kSpread);
    const auto average = ping < rhythm_.settling ? kSettling : rhythm_.average;
    return std::chrono::duration_cast<std::chrono::nanoseconds>(average * share(random_));
  }

 private:
  const Rhythm rhythm_;
  std::minstd_rand random_;
  int pings_ = 0;  // on this connection
};

}  // namespace roomcast::client
