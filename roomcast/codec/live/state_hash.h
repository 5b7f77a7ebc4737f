// SPDX-License-Identifier: Apache-2.0
// Hash that shows whether two live depth states are equal: each frame's levels are mixed into the
// hash of the frame that it depends on. Detects lost frames, damage and disagreement, not forgery.
// docs/spec/codec.md §2.4.7.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {

class StateHash {
 public:
  explicit StateHash(std::uint32_t seed) : hash_(seed) {}

  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15u;
    hash_ ^= hash_ >> 32;
  }
  /// Adds a whole block.
  void add(const std::array<std::uint16_t, kBlockPixels>& levels) {
    for (std::size_t i = 0; i < kBlockPixels; i += 4) {
      add(std::uint64_t{levels[i]} | std::uint64_t{levels[i + 1]} << 16 |
          std::uint64_t{levels[i + 2]} << 32 | std::uint64_t{levels[i + 3]} << 48);
    }
  }
  [[nodiscard]] std::uint32_t value() const { return static_cast<std::uint32_t>(hash_); }

 private:
  std::uint64_t hash_;
};

}  // namespace roomcast::codec
