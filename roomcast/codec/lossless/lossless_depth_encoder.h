// SPDX-License-Identifier: Apache-2.0
// Encodes depth without loss, each frame by itself: a depth section of codec 1. docs/spec/codec.md
// §2.
//
// Two passes: the first predicts every pixel and counts the tokens, the second codes them backwards
// with an asymmetric numeral system (Duda 2013, arXiv:1311.2540), which is what makes the decoder
// fast.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/lossless/side_information.h"
#include "roomcast/codec/lossless/table_merging.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class LosslessDepthEncoder {
 public:
  /// Appends the section's bytes to `out`. Any values, at least 16x16 pixels.
  void encode(DepthView depth_mm, std::vector<std::uint8_t>& out);

 private:
  using Symbol = std::uint32_t;
  void map_values(DepthView depth_mm);
  void tokenise(DepthView plane, int first_row, int end_row);
  void append_slice(std::size_t first_symbol, std::size_t end_symbol,
                    std::vector<std::uint8_t>& out);

  SideInformation side_;
  std::vector<std::uint16_t> index_of_value_;
  std::vector<std::uint16_t> plane_;
  std::vector<Symbol> symbols_;
  std::array<TokenCounts, kContextCount> counts_{};
  std::vector<FrequencyTable> tables_;
  std::vector<std::uint8_t> words_;
  CellRows rows_;
};

}  // namespace roomcast::codec
