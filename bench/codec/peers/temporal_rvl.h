// SPDX-License-Identifier: Apache-2.0
// Temporal RVL, a peer for comparison. Implemented from its description: Jun and Bailenson,
// "Temporal RVL: A Depth Stream Compression Method", IEEE VR 2020: a pixel keeps its value until a
// reading differs by more than a threshold, or is missing twice in a row. Changes are coded as
// differences by RVL. Millimetres. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::bench {

class TemporalRvlEncoder {
 public:
  TemporalRvlEncoder(std::size_t pixel_count, int threshold_mm);
  /// Appends to `out`.
  void encode(std::span<const std::uint16_t> depth_mm, bool key, std::vector<std::uint8_t>& out);

 private:
  void update(std::span<const std::uint16_t> depth_mm);

  int threshold_mm_;
  std::vector<std::uint16_t> kept_mm_;
  std::vector<std::uint8_t> times_invalid_;
  std::vector<std::int16_t> differences_;
};

class TemporalRvlDecoder {
 public:
  explicit TemporalRvlDecoder(std::size_t pixel_count);
  /// Accepts only bytes from the encoder. The result is valid until the next call.
  std::span<const std::uint16_t> decode(std::span<const std::uint8_t> bytes, bool key);

 private:
  std::vector<std::uint16_t> kept_mm_;
  std::vector<std::int16_t> differences_;
};

}  // namespace roomcast::bench
