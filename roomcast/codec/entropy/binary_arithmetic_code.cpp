// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/entropy/binary_arithmetic_code.h"

namespace roomcast::codec {

void ArithmeticEncoder::put_raw(std::uint32_t value, int bits) {
  for (int i = bits - 1; i >= 0; --i) {
    range_ >>= 1;
    if ((value >> i) & 1) low_ += range_;
    normalise();
  }
}

void ArithmeticEncoder::finish() {
  for (int i = 0; i < 5; ++i) shift_out_byte();
  while (out_.size() > begin_ && out_.back() == 0) out_.pop_back();
}

void ArithmeticEncoder::shift_out_byte() {
  const bool carry = (low_ >> 32) != 0;
  const auto byte = static_cast<std::uint8_t>(low_ >> 24);
  if (byte == 0xFF && !carry) {
    ++pending_;
  } else {
    if (holds_) out_.push_back(static_cast<std::uint8_t>(held_ + carry));
    for (; pending_ > 0; --pending_) out_.push_back(carry ? 0x00 : 0xFF);
    held_ = byte;
    holds_ = true;
  }
  low_ = (low_ & 0x00FFFFFFu) << 8;
}

}  // namespace roomcast::codec
