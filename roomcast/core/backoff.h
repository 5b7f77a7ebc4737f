// SPDX-License-Identifier: Apache-2.0
// Backoff: the delay before the next attempt to reach a hub or a camera. The delay doubles with
// each consecutive failure, up to kLongest. A random factor in [kMinShare, 1] spreads the
// reconnections of many clients after a hub restart (exponential back-off with jitter: Metcalfe and
// Boggs 1976). No I/O, no clock.
#pragma once

#include <algorithm>
#include <chrono>
#include <random>

namespace roomcast {

class Backoff {
 public:
  static constexpr std::chrono::milliseconds kFirst{250}, kLongest{4'000};
  static constexpr double kMinShare = 0.75;

  explicit Backoff(std::uint32_t seed) : random_(seed) {}

  /// Resets the delay to kFirst after a successful attempt.
  void succeeded() { pause_ = kFirst; }

  [[nodiscard]] std::chrono::nanoseconds next() {
    std::uniform_real_distribution<double> share(kMinShare, 1);
    const auto pause =
        std::chrono::duration_cast<std::chrono::nanoseconds>(pause_ * share(random_));
    pause_ = std::min(2 * pause_, kLongest);
    return pause;
  }

 private:
  std::minstd_rand random_;
  std::chrono::milliseconds pause_ = kFirst;
};

}  // namespace roomcast
