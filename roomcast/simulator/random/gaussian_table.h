// SPDX-License-Identifier: Apache-2.0
// Gaussian numbers that are a function of a counter: the hash of (seed, sensor, frame, pixel) picks
// one of 65536 equally likely quantiles of the normal distribution. No state, so any thread may ask
// for any pixel in any order and gets the same number. Built with libm's erfc only.
#pragma once

#include <cstdint>
#include <vector>

namespace roomcast::simulator {

class GaussianTable {
 public:
  GaussianTable();

  /// Mean 0, deviation 1, at most 4.3 deviations away.
  [[nodiscard]] float of_hash(std::uint32_t hash) const { return quantiles_[hash >> 16]; }

  /// At least kRun numbers in random order, from a place chosen by the hash.
  static constexpr std::size_t kRun = 3 * 4096;
  [[nodiscard]] const std::int8_t* shuffled_run(std::uint32_t hash) const {
    return &shuffled_[hash >> 16];
  }
  /// What one deviation is in the numbers of a run.
  static constexpr int kRunScale = 28;

 private:
  static constexpr std::size_t kSize = 1U << 16;
  std::vector<float> quantiles_;
  std::vector<std::int8_t> shuffled_;
};

}  // namespace roomcast::simulator
