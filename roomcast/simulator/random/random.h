// SPDX-License-Identifier: Apache-2.0
// Random: a pseudo-random sequence from a seed, for the choices that distinguish rooms of one kind.
// Single-threaded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {

class Random {
 public:
  explicit Random(std::uint32_t seed) : seed_(seed) {}

  /// Uniform between the two.
  float between(float low, float high) { return low + (high - low) * unit_from_hash(next()); }
  /// Uniform in 0 .. count - 1.
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint32_t>(count)); }
  bool chance(float probability) { return unit_from_hash(next()) < probability; }
  template <class T, std::size_t N>
  const T& one_of(const std::array<T, N>& choices) {
    return choices[static_cast<std::size_t>(below(static_cast<int>(N)))];
  }
  /// A seed for another generator or for a pattern.
  std::uint32_t seed() { return next(); }

 private:
  std::uint32_t next() { return hash_of(seed_, count_++); }

  std::uint32_t seed_;
  std::uint32_t count_ = 0;
};

}  // namespace roomcast::simulator
