// SPDX-License-Identifier: Apache-2.0
// Encodes depth without loss (a depth section of codec 1) or within a bound (codec 3), each frame
// by itself. docs/spec/codec.md §2.
//
// Two passes: the first predicts every pixel and counts the tokens, the second codes them backwards
// with an asymmetric numeral system (Duda 2013, arXiv:1311.2540), which is what makes the decoder
// fast.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/lossless/side_information.h"
#include "roomcast/codec/lossless/table_merging.h"
#include "roomcast/codec/lossless/value_table.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// A token in a frequency table, as the coder needs it.
struct TokenCode {
  std::uint64_t reciprocal = 0;  // 2^44 / frequency, rounded up
  std::uint32_t frequency = 0, start = 0;
};

/// Keeps its memory from frame to frame.
class LosslessDepthEncoder {
 public:
  /// Appends the section's bytes to `out`. Any values, at least 16x16 pixels.
  void encode(DepthView depth_mm, std::vector<std::uint8_t>& out);

  /// The same for a section of codec 3: every reading decodes to at most `bound_mm`
  /// (1..kMaxBound_mm) from what it is, and what has none stays without.
  void encode_near_lossless(DepthView depth_mm, int bound_mm, std::vector<std::uint8_t>& out);

  /// What the newest near-lossless section decodes to. Valid until the next call.
  [[nodiscard]] DepthView decoded_mm() const { return plane_; }

 private:
  using Symbol = std::uint32_t;
  void map_values(DepthView depth_mm, int bound_mm);
  template <class Residual>
  void encode_plane(const Residual& residual, std::vector<std::uint8_t>& out);
  template <class Residual>
  void tokenise(const Residual& residual, int first_row, int end_row);
  void build_codes();
  /// Both slices, whose border this is; gives the length of the first.
  std::size_t append_slices(std::size_t top_pixels, std::vector<std::uint8_t>& out);

  SideInformation side_;
  ValueTable values_;
  DepthImage plane_;  // what is coded: depth, or indices of values; then what it decodes to
  std::vector<Symbol> symbols_;
  std::array<TokenCounts, kContextCount> counts_{};
  std::vector<std::array<TokenCode, kTokenCount>> codes_;  // one for each frequency table
  std::vector<std::uint8_t> top_words_, bottom_words_;
  CellRows rows_;
};

}  // namespace roomcast::codec
