// SPDX-License-Identifier: Apache-2.0
// Frequencies of tokens, to 12 bits, and their coding. docs/spec/codec.md §2.1. Frequencies are
// sent as small floating-point weights (two bits of mantissa), which costs under 0.5 % of coding
// efficiency and takes a third of the bits of exact ones.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "roomcast/codec/entropy/binary_arithmetic_code.h"

namespace roomcast::codec {

inline constexpr int kFrequencyBits = 12;
inline constexpr std::uint32_t kFrequencySum = 1u << kFrequencyBits;
inline constexpr int kTokenCount = 77;

using Weights = std::array<std::uint32_t, kTokenCount>;

/// `frequency` sums to kFrequencySum; `start[t]` is the sum of the frequencies before t.
struct FrequencyTable {
  std::array<std::uint16_t, kTokenCount> frequency{};
  std::array<std::uint16_t, kTokenCount> start{};
};

/// Adaptive probabilities for sending tables, shared by all tables of a frame.
struct WeightModel {
  std::array<BitTree<4>, 16> exponent;
};

/// Returns the nearest weights that can be sent, at least 1 for tokens that occur.
[[nodiscard]] Weights sendable_weights(std::span<const std::uint32_t, kTokenCount> counts);

/// `weights` must come from sendable_weights and not be all zero.
void put_weights(ArithmeticEncoder& encoder, WeightModel& model, const Weights& weights);

/// Returns false if the bytes give no table: too many tokens, or none with a weight.
[[nodiscard]] bool get_weights(ArithmeticDecoder& decoder, WeightModel& model, Weights& weights);

/// Scales weights (not all zero, below 2^16 each) to frequencies.
[[nodiscard]] FrequencyTable normalised(const Weights& weights);

}  // namespace roomcast::codec
