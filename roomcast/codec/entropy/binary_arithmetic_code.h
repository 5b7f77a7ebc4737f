// SPDX-License-Identifier: Apache-2.0
// Adaptive binary arithmetic coding for side information and masks. docs/spec/codec.md §4.
// Carry-propagating range coder (Martin 1979; byte-wise renormalisation as in the LZMA
// specification); the probability is the mean of a fast and a slow estimate. Integer only. A
// decoder reads zeros past its bytes: no input is an error.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::codec {

/// Probability that the next bit is 0, estimated from the bits before it.
class AdaptiveBit {
 public:
  /// In 1/65536.
  [[nodiscard]] std::uint32_t probability_of_zero() const {
    const std::uint32_t mean = (static_cast<std::uint32_t>(fast_) + slow_) >> 1;
    return mean < kMin ? kMin : mean > kMax ? kMax : mean;
  }
  void learn(bool bit) {
    if (bit) {
      fast_ = static_cast<std::uint16_t>(fast_ - (fast_ >> kFastShift));
      slow_ = static_cast<std::uint16_t>(slow_ - (slow_ >> kSlowShift));
    } else {
      fast_ = static_cast<std::uint16_t>(fast_ + ((65535 - fast_) >> kFastShift));
      slow_ = static_cast<std::uint16_t>(slow_ + ((65535 - slow_) >> kSlowShift));
    }
  }

 private:
  static constexpr std::uint32_t kMin = 64, kMax = 65536 - 64;
  static constexpr int kFastShift = 4, kSlowShift = 7;
  std::uint16_t fast_ = 32768, slow_ = 32768;
};

/// A number of `Bits` bits, each with a probability that depends on the higher ones.
template <int Bits>
struct BitTree {
  std::array<AdaptiveBit, 1u << Bits> nodes;
};

/// Appends to a vector owned by the caller.
class ArithmeticEncoder {
 public:
  explicit ArithmeticEncoder(std::vector<std::uint8_t>& out) : out_(out), begin_(out.size()) {}

  void put(AdaptiveBit& bit, bool value) {
    const std::uint32_t bound = (range_ >> 16) * bit.probability_of_zero();
    if (value) {
      low_ += bound;
      range_ -= bound;
    } else {
      range_ = bound;
    }
    bit.learn(value);
    normalise();
  }
  void put_raw(std::uint32_t value, int bits);
  template <int Bits>
  void put(BitTree<Bits>& tree, std::uint32_t value) {
    std::uint32_t node = 1;
    for (int i = Bits - 1; i >= 0; --i) {
      const bool bit = (value >> i) & 1;
      put(tree.nodes[node], bit);
      node = 2 * node + bit;
    }
  }
  /// Must be called once, last.
  void finish();

 private:
  void normalise() {
    while (range_ < (1u << 24)) {
      range_ <<= 8;
      shift_out_byte();
    }
  }
  void shift_out_byte();

  std::vector<std::uint8_t>& out_;
  std::size_t begin_;
  std::uint64_t low_ = 0;
  std::uint32_t range_ = 0xFFFFFFFFu;
  std::uint64_t pending_ = 0;  // number of 0xFF bytes that a carry may still change
  std::uint8_t held_ = 0;      // the byte before them
  bool holds_ =
      false;  // false until there is one: the first byte shifted out is always 0 and is dropped
};

class ArithmeticDecoder {
 public:
  explicit ArithmeticDecoder(std::span<const std::uint8_t> bytes)
      : next_(bytes.data()), end_(bytes.data() + bytes.size()) {
    for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next_byte();
  }

  [[nodiscard]] bool get(AdaptiveBit& bit) {
    const std::uint32_t bound = (range_ >> 16) * bit.probability_of_zero();
    const bool value = code_ >= bound;
    if (value) {
      code_ -= bound;
      range_ -= bound;
    } else {
      range_ = bound;
    }
    bit.learn(value);
    normalise();
    return value;
  }
  [[nodiscard]] std::uint32_t get_raw(int bits) {
    std::uint32_t value = 0;
    for (; bits > 0; --bits) {
      range_ >>= 1;
      const bool bit = code_ >= range_;
      if (bit) code_ -= range_;
      value = 2 * value + bit;
      normalise();
    }
    return value;
  }
  template <int Bits>
  [[nodiscard]] std::uint32_t get(BitTree<Bits>& tree) {
    std::uint32_t node = 1;
    for (int i = 0; i < Bits; ++i) node = 2 * node + get(tree.nodes[node]);
    return node - (1u << Bits);
  }

 private:
  std::uint8_t next_byte() { return next_ < end_ ? *next_++ : 0; }
  void normalise() {
    while (range_ < (1u << 24)) {
      range_ <<= 8;
      code_ = code_ << 8 | next_byte();
    }
  }

  const std::uint8_t* next_;
  const std::uint8_t* end_;
  std::uint32_t range_ = 0xFFFFFFFFu;
  std::uint32_t code_ = 0;
};

}  // namespace roomcast::codec
