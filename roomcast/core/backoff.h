// SPDX-License-Identifier: Apache-2.0
// Backoff: how long to wait before the next try to reach a hub or a camera. Doubles with every
// failure in a row, up to a few seconds; random within a quarter, so that a hub that comes back is
// not met by all its clients at once (exponential back-off with jitter: Metcalfe and Boggs 1976).
// Pure.
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

  /// It worked: after the next failure begin again with the shortest.
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
