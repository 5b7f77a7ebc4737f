// SPDX-License-Identifier: Apache-2.0
// Adaptive probabilities of the live depth stream, and the coding of numbers with them.
// docs/spec/codec.md §2.4.2 to §2.4.6.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "roomcast/codec/entropy/binary_arithmetic_code.h"
#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {

/// Model of a number >= 0: one adaptive bit for each step up to `Steps`, then its length, then its
/// bits.
template <int Steps>
struct NumberModel {
  static constexpr int kMaxLength = 19;
  std::array<AdaptiveBit, Steps> steps;
  std::array<AdaptiveBit, kMaxLength> longer;
  std::array<AdaptiveBit, kMaxLength + 1> second;
};

/// Model of a block's coefficients.
struct CoefficientModel {
  BitTree<6> count;  // coefficients up to the last that is not 0
  std::array<AdaptiveBit, kBlockPixels> present;
  std::array<NumberModel<4>, 3> magnitude;  // low, middle and high frequencies
};

inline constexpr int kSurfaceCandidates = 6;

struct LiveContexts {
  std::array<AdaptiveBit, 54> active;
  AdaptiveBit labelled, raw;
  AdaptiveBit any_surface, two_surfaces;
  std::array<std::array<AdaptiveBit, kSurfaceCandidates>, 4> candidate;
  std::array<AdaptiveBit, 2> finer;
  std::array<NumberModel<14>, 2> mean;
  std::array<std::array<NumberModel<8>, 2>, 2> slope;
  std::array<CoefficientModel, 3> coefficients;  // surface, finer surface, refinement
  std::array<AdaptiveBit, 5> uniform;
  std::array<AdaptiveBit, 1024> on_surface;
  std::array<AdaptiveBit, 27> which_surface;
  std::array<AdaptiveBit, 8> background;
  std::array<AdaptiveBit, 4> vanished;
  std::array<AdaptiveBit, 4> raw_reading;
  NumberModel<14> raw_difference;
};

/// Writes the given values. Has the interface of LiveReader, so that one template does both.
class LiveWriter {
 public:
  static constexpr bool kWrites = true;
  explicit LiveWriter(std::vector<std::uint8_t>& out) : code_(out) {}
  bool bit(AdaptiveBit& model, bool value) {
    code_.put(model, value);
    return value;
  }
  std::uint32_t plain(std::uint32_t value, int bits) {
    code_.put_raw(value, bits);
    return value;
  }
  void finish() { code_.finish(); }

 private:
  ArithmeticEncoder code_;
};

/// Reads; ignores the given values.
class LiveReader {
 public:
  static constexpr bool kWrites = false;
  explicit LiveReader(std::span<const std::uint8_t> bytes) : code_(bytes) {}
  bool bit(AdaptiveBit& model, bool) { return code_.get(model); }
  std::uint32_t plain(std::uint32_t, int bits) { return code_.get_raw(bits); }

 private:
  ArithmeticDecoder code_;
};

/// `value` at most 2^19.
template <class Coder, int Steps>
std::uint32_t code_number(Coder& coder, NumberModel<Steps>& model, std::uint32_t value) {
  for (std::uint32_t i = 0; i < Steps; ++i) {
    if (!coder.bit(model.steps[i], value != i)) return i;
  }
  const std::uint32_t rest = value - Steps + 1;  // at least 1
  const int length = Coder::kWrites ? std::bit_width(rest) - 1 : 0;
  int n = 0;
  while (n < NumberModel<Steps>::kMaxLength &&
         coder.bit(model.longer[static_cast<std::size_t>(n)], n < length)) {
    ++n;
  }
  if (n == 0) return Steps;
  const bool second = coder.bit(model.second[static_cast<std::size_t>(n)], (rest >> (n - 1)) & 1);
  const std::uint32_t low = coder.plain(rest & ((1u << (n - 1)) - 1), n - 1);
  return ((2u + second) << (n - 1) | low) - 1 + Steps;
}

template <class Coder, int Bits>
std::uint32_t code_tree(Coder& coder, BitTree<Bits>& tree, std::uint32_t value) {
  std::uint32_t node = 1;
  for (int i = Bits - 1; i >= 0; --i)
    node = 2 * node + coder.bit(tree.nodes[node], (value >> i) & 1);
  return node - (1u << Bits);
}

[[nodiscard]] constexpr std::uint32_t fold_sign(std::int32_t v) {
  return static_cast<std::uint32_t>(v) << 1 ^ static_cast<std::uint32_t>(v >> 31);
}
[[nodiscard]] constexpr std::int32_t unfold_sign(std::uint32_t v) {
  return static_cast<std::int32_t>(v >> 1) ^ -static_cast<std::int32_t>(v & 1);
}

}  // namespace roomcast::codec
