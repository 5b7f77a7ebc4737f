// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/frequency_table.h"

#include <algorithm>
#include <bit>

namespace roomcast::codec {
namespace {

constexpr int kMantissaBits = 2;
constexpr int kCountBits = 7;
// Counts are scaled below this so that every exponent fits the 4-bit tree.
constexpr std::uint32_t kLargestWeight = 0x7000;

int exponent_of(std::uint32_t weight) {
  return static_cast<int>(std::bit_width(weight));
}
int mantissa_bits(int exponent) {
  return std::min(exponent - 1, kMantissaBits);
}

/// Rounds to 1 + kMantissaBits significant bits.
std::uint32_t round_to_mantissa(std::uint32_t weight) {
  const int dropped = exponent_of(weight) - 1 - kMantissaBits;
  if (dropped <= 0) return weight;
  const std::uint32_t half = 1u << (dropped - 1);
  return (weight + half) >> dropped << dropped;
}

}  // namespace

Weights sendable_weights(std::span<const std::uint32_t, kTokenCount> counts) {
  const std::uint64_t largest = *std::max_element(counts.begin(), counts.end());
  Weights weights{};
  for (int t = 0; t < kTokenCount; ++t) {
    if (counts[t] == 0) continue;
    std::uint64_t scaled = counts[t];
    if (largest > kLargestWeight)
      scaled = std::max<std::uint64_t>(1, scaled * kLargestWeight / largest);
    weights[t] = round_to_mantissa(static_cast<std::uint32_t>(scaled));
  }
  return weights;
}

void put_weights(ArithmeticEncoder& encoder, WeightModel& model, const Weights& weights) {
  int count = kTokenCount;
  while (weights[count - 1] == 0) --count;
  encoder.put_raw(static_cast<std::uint32_t>(count), kCountBits);
  int previous = 0;
  for (int t = 0; t < count; ++t) {
    const int exponent = exponent_of(weights[t]);
    encoder.put(model.exponent[previous], static_cast<std::uint32_t>(exponent));
    if (exponent > 1) {
      const int bits = mantissa_bits(exponent);
      encoder.put_raw(weights[t] >> (exponent - 1 - bits) & ((1u << bits) - 1), bits);
    }
    previous = exponent;
  }
}

bool get_weights(ArithmeticDecoder& decoder, WeightModel& model, Weights& weights) {
  weights.fill(0);
  const auto count = static_cast<int>(decoder.get_raw(kCountBits));
  if (count > kTokenCount) return false;
  std::uint32_t any = 0;
  int previous = 0;
  for (int t = 0; t < count; ++t) {
    const auto exponent = static_cast<int>(decoder.get(model.exponent[previous]));
    if (exponent > 0) {
      const int bits = mantissa_bits(exponent);
      weights[t] = ((1u << bits) | decoder.get_raw(bits)) << (exponent - 1 - bits);
    }
    any |= weights[t];
    previous = exponent;
  }
  return any != 0;
}

FrequencyTable normalised(const Weights& weights) {
  std::uint32_t weight_sum = 0;
  for (const std::uint32_t weight : weights) weight_sum += weight;
  FrequencyTable table;
  std::uint32_t sum = 0;
  int most = 0;
  for (int t = 0; t < kTokenCount; ++t) {
    if (weights[t] == 0) continue;
    const std::uint32_t share = weights[t] * kFrequencySum / weight_sum;
    table.frequency[t] = static_cast<std::uint16_t>(std::max(1u, share));
    sum += table.frequency[t];
    if (table.frequency[t] > table.frequency[most]) most = t;
  }
  // Raising tokens to 1 adds less than the largest share, whatever the weights (77 tokens, 4096
  // shares).
  table.frequency[most] = static_cast<std::uint16_t>(table.frequency[most] + kFrequencySum - sum);
  std::uint32_t start = 0;
  for (int t = 0; t < kTokenCount; ++t) {
    table.start[t] = static_cast<std::uint16_t>(start);
    start += table.frequency[t];
  }
  return table;
}

}  // namespace roomcast::codec
