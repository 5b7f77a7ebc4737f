// SPDX-License-Identifier: Apache-2.0
// PingPace: how long a client waits before it asks for room time again. The first few questions
// come quickly, to know the time soon; later ones at random distances, because frames come at
// regular ones, and a ping that falls in step with them waits behind a frame every time
// (measured: 6.9 ms wrong instead of 7 us). docs/spec/wire.md section 3, "Clock". Pure.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>

namespace roomcast {

class PingPace {
 public:
  static constexpr int kQuickPings = 5;
  /// Of whom the first are quick: what ClockSync needs to know the drift.
  static constexpr int kSettlingPings = 160;
  static constexpr std::chrono::milliseconds kQuickPing{20};
  /// Who stamps frames needs the time to microseconds; who shows them does not.
  static constexpr std::chrono::milliseconds kOfSensor{100}, kOfViewer{500};
  static constexpr double kSpread = 0.7;  // of the average, either way

  PingPace(std::chrono::milliseconds average, std::uint32_t seed)
      : average_(average), random_(seed) {}

  /// A new connection: begin with the quick ones.
  void start_anew() { pings_ = 0; }

  [[nodiscard]] std::chrono::nanoseconds next() {
    const int ping = pings_++;
    if (ping < kQuickPings) return kQuickPing;
    std::uniform_real_distribution<double> share(1 - kSpread, 1 + kSpread);
    const auto average = ping < kSettlingPings ? std::min(average_, kOfSensor) : average_;
    return std::chrono::duration_cast<std::chrono::nanoseconds>(average * share(random_));
  }

 private:
  std::chrono::milliseconds average_;
  std::minstd_rand random_;
  int pings_ = 0;  // on this connection
};

}  // namespace roomcast
