// SPDX-License-Identifier: Apache-2.0
// Chooses the value table of a depth frame. Structured-light sensors have few distinct distances,
// so that coding them by index saves bits; the indices are nearly linear in disparity, in which
// planes are planes. Within a bound, one value represents several. docs/spec/codec.md §2.1.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class ValueTable {
 public:
  /// Returns whether a table saves bits for this frame. Fills in `values`: 0, then ascending, so
  /// that every reading is at most `bound_mm` from one of them.
  [[nodiscard]] bool choose(DepthView depth_mm, int bound_mm, std::vector<std::uint16_t>& values);

  /// Maps the frame of the last `choose` to indices. Sizes must be equal.
  void map(DepthView depth_mm, ImageView<std::uint16_t> indices) const;

 private:
  void mark_values(DepthView depth_mm);
  void group(int bound_mm, std::vector<std::uint16_t>& values);

  std::vector<std::uint16_t> index_of_value_;  // during `choose`: whether the value occurs
};

}  // namespace roomcast::codec
