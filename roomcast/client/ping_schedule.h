// SPDX-License-Identifier: Apache-2.0
// PingSchedule: how long a client waits before it asks for room time again. The first few questions
// come quickly, to know the time soon; later ones at random distances, because frames come at
// regular ones, and a ping that falls in step with them waits behind a frame every time
// (measured: 6.9 ms wrong instead of 7 us). docs/spec/wire.md section 3, "Clock". Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace roomcast::client {

class PingSchedule {
 public:
  struct Rhythm {
    int quick;                          // at first, one every kQuickPing
    std::chrono::milliseconds average;  // then
    int settling;                       // how many come every kSettling before that
  };
  static constexpr std::chrono::milliseconds kQuickPing{20}, kSettling{100};
  static constexpr double kSpread = 0.7;  // of the average, either way

  /// 160 are what ClockSync needs to know the drift. Who stamps frames needs the time to
  /// microseconds; who shows them does not.
  static constexpr Rhythm kOfSensor{.quick = 5, .average = kSettling, .settling = 0};
  static constexpr Rhythm kOfViewer{
      .quick = 5, .average = std::chrono::milliseconds(500), .settling = 160};
  /// A hub that serves on what another one has begins anew for everybody who comes to look, and
  /// each question wakes this hub twice and the other one once, which costs more than a set of
  /// frames. In two seconds clocks part by no more than 0.2 ms.
  static constexpr Rhythm kOfHub{
      .quick = 32, .average = std::chrono::milliseconds(2000), .settling = 0};

  PingSchedule(const Rhythm& rhythm, std::uint32_t seed) : rhythm_(rhythm), random_(seed) {}

  /// A new connection: begin with the quick ones.
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
