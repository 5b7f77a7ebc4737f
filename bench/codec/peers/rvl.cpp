// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/peers/rvl.h"

#include <algorithm>

namespace roomcast::bench {
namespace {

constexpr int kNibblesPerWord = 8;

/// Words are filled from their highest nibble.
class NibbleWriter {
 public:
  explicit NibbleWriter(std::vector<std::uint8_t>& out) : out_(out) {}
  void put(std::uint32_t value) {
    do {
      std::uint32_t nibble = value & 7;
      value >>= 3;
      if (value) nibble |= 8;
      word_ = word_ << 4 | nibble;
      if (++count_ == kNibblesPerWord) flush();
    } while (value);
  }
  void finish() {
    if (count_ == 0) return;
    word_ <<= 4 * (kNibblesPerWord - count_);
    flush();
  }

 private:
  void flush() {
    for (int i = 0; i < 4; ++i) out_.push_back(static_cast<std::uint8_t>(word_ >> 8 * i));
    count_ = 0;
    word_ = 0;
  }
  std::vector<std::uint8_t>& out_;
  std::uint32_t word_ = 0;
  int count_ = 0;
};

class NibbleReader {
 public:
  explicit NibbleReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t get() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 3) {
      const std::uint32_t nibble = next();
      value |= (nibble & 7) << shift;
      if (!(nibble & 8)) break;
    }
    return value;
  }

 private:
  std::uint32_t next() {
    if (count_ == 0) {
      word_ = 0;
      for (std::size_t i = 0; i < 4 && at_ < bytes_.size(); ++i) {
        word_ |= static_cast<std::uint32_t>(bytes_[at_++]) << 8 * i;
      }
      count_ = kNibblesPerWord;
    }
    --count_;
    const std::uint32_t nibble = word_ >> 28;
    word_ <<= 4;
    return nibble;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::uint32_t word_ = 0;
  int count_ = 0;
};

template <class Value>
void encode(std::span<const Value> values, std::vector<std::uint8_t>& out) {
  NibbleWriter writer(out);
  int previous = 0;
  for (auto at = values.begin(); at != values.end();) {
    const auto reading = std::find_if(at, values.end(), [](Value v) { return v != 0; });
    const auto hole = std::find(reading, values.end(), Value{0});
    writer.put(static_cast<std::uint32_t>(reading - at));
    writer.put(static_cast<std::uint32_t>(hole - reading));
    for (at = reading; at != hole; ++at) {
      const int delta = *at - previous;
      writer.put(static_cast<std::uint32_t>(delta) << 1 ^ static_cast<std::uint32_t>(delta >> 31));
      previous = *at;
    }
  }
  writer.finish();
}

template <class Value>
void decode(std::span<const std::uint8_t> bytes, std::span<Value> values) {
  NibbleReader reader(bytes);
  int previous = 0;
  for (std::size_t at = 0; at < values.size();) {
    const std::size_t holes = std::min<std::size_t>(reader.get(), values.size() - at);
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(at), holes, Value{0});
    at += holes;
    const std::size_t end = at + std::min<std::size_t>(reader.get(), values.size() - at);
    for (; at < end; ++at) {
      const std::uint32_t folded = reader.get();
      previous += static_cast<int>(folded >> 1) ^ -static_cast<int>(folded & 1);
      values[at] = static_cast<Value>(previous);
    }
  }
}

}  // namespace

void encode_rvl(std::span<const std::uint16_t> depth, std::vector<std::uint8_t>& out) {
  encode(depth, out);
}
void encode_rvl(std::span<const std::int16_t> differences, std::vector<std::uint8_t>& out) {
  encode(differences, out);
}
void decode_rvl(std::span<const std::uint8_t> bytes, std::span<std::uint16_t> depth) {
  decode(bytes, depth);
}
void decode_rvl(std::span<const std::uint8_t> bytes, std::span<std::int16_t> differences) {
  decode(bytes, differences);
}

}  // namespace roomcast::bench
