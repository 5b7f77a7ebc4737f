// SPDX-License-Identifier: Apache-2.0
// Deterministic randomness: integer hashes, and smooth noise made from them. The same arguments
// always give the same value, on every thread and in every process. Lengths in metres. The bit
// mixer is the finaliser of MurmurHash3 (public domain); value noise: Perlin 1985, with lattice
// values instead of gradients.
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace roomcast::simulator {

[[nodiscard]] constexpr std::uint32_t mix_bits(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bU;
  x ^= x >> 13;
  x *= 0xc2b2ae35U;
  return x ^ (x >> 16);
}

/// Hash of two numbers; chain calls for more.
[[nodiscard]] constexpr std::uint32_t hash_of(std::uint32_t a, std::uint32_t b) {
  return mix_bits(a + 0x9e3779b9U * mix_bits(b + 0x7f4a7c15U));
}

/// 0 <= value < 1.
[[nodiscard]] constexpr float unit_from_hash(std::uint32_t hash) {
  return static_cast<float>(hash >> 8) * (1.0F / 16777216.0F);
}

/// The n-th of the independent values, 0 <= value < 1, that are derived from a hash.
[[nodiscard]] constexpr float nth_unit(std::uint32_t hash, std::uint32_t n) {
  return unit_from_hash(hash_of(hash, n));
}

/// Smooth, -1..1, lattice spacing 1.
[[nodiscard]] float value_noise(const Eigen::Vector2f& at, std::uint32_t seed);

/// Octaves of value noise from `wavelength_m` down, each with half the wavelength and amplitude,
/// about -1..1. Octaves finer than `footprint_m` (the width seen by one pixel) are faded out, so
/// that distant surfaces do not shimmer.
[[nodiscard]] float fractal_noise(const Eigen::Vector2f& at_m, float wavelength_m, int octaves,
                                  float footprint_m, std::uint32_t seed);

}  // namespace roomcast::simulator
