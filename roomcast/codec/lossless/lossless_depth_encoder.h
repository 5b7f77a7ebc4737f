// SPDX-License-Identifier: Apache-2.0
// Encodes depth without loss (a depth section of codec 1) or within a bound (codec 3), each frame
// by itself. docs/spec/codec.md §2.1 to §2.3.
//
// Two passes: the first predicts every pixel and counts the tokens, the second codes them in
// reverse order with an asymmetric numeral system (Duda 2013, arXiv:1311.2540), which makes the
// decoder fast.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/lossless/side_information.h"
#include "roomcast/codec/lossless/table_merging.h"
#include "roomcast/codec/lossless/value_table.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// A token in a frequency table, prepared for the coder.
struct TokenCode {
  std::uint64_t reciprocal = 0;  // 2^44 / frequency, rounded up
  std::uint32_t frequency = 0, start = 0;
};

/// Keeps its memory from frame to frame.
class LosslessDepthEncoder {
 public:
  /// Appends the section's bytes to `out`. Any values, at least 16x16 pixels.
  void encode(DepthView depth_mm, std::vector<std::uint8_t>& out);

  /// The same for a section of codec 3: every reading decodes within `bound_mm` (1..kMaxBound_mm)
  /// of its value, and holes stay holes.
  void encode_near_lossless(DepthView depth_mm, int bound_mm, std::vector<std::uint8_t>& out);

  /// The decoded picture of the newest near-lossless section. Valid until the next call.
  [[nodiscard]] DepthView decoded_mm() const { return plane_; }

 private:
  using Symbol = std::uint32_t;
  void map_values(DepthView depth_mm, int bound_mm);
  template <class Residual>
  void encode_plane(const Residual& residual, std::vector<std::uint8_t>& out);
  template <class Residual>
  void tokenise(const Residual& residual, int first_row, int end_row);
  void build_codes();
  /// Appends both slices; the top one has `top_pixels` pixels. Returns the length of the top slice.
  std::size_t append_slices(std::size_t top_pixels, std::vector<std::uint8_t>& out);

  SideInformation side_;
  ValueTable values_;
  DepthImage plane_;  // input of the coder: depth, or indices of values; then the decoded picture
  std::vector<Symbol> symbols_;
  std::array<TokenCounts, kContextCount> counts_{};
  std::vector<std::array<TokenCode, kTokenCount>> codes_;  // one for each frequency table
  std::vector<std::uint8_t> top_words_, bottom_words_;
  CellRows rows_;
};

}  // namespace roomcast::codec
