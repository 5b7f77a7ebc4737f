// SPDX-License-Identifier: Apache-2.0
// GaussianTable: Gaussian numbers as a function of a counter: the hash of (seed, sensor, frame,
// pixel) selects one of 65536 equally likely quantiles of the normal distribution. Stateless, so
// any thread can compute any pixel in any order with the same result. Uses only erfc of libm.
#pragma once

#include <cstdint>
#include <vector>

namespace roomcast::simulator {

class GaussianTable {
 public:
  GaussianTable();

  /// Mean 0, standard deviation 1, absolute value at most 4.3.
  [[nodiscard]] float of_hash(std::uint32_t hash) const { return quantiles_[hash >> 16]; }

  /// At least kRun numbers in random order, starting at a position selected by the hash.
  static constexpr std::size_t kRun = 3 * 4096;
  [[nodiscard]] const std::int8_t* shuffled_run(std::uint32_t hash) const {
    return &shuffled_[hash >> 16];
  }
  /// The standard deviation of the numbers of a run.
  static constexpr int kRunScale = 28;

 private:
  static constexpr std::size_t kSize = 1U << 16;
  std::vector<float> quantiles_;
  std::vector<std::int8_t> shuffled_;
};

}  // namespace roomcast::simulator
