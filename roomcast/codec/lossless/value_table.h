// SPDX-License-Identifier: Apache-2.0
// Chooses the value table of a depth frame: structured-light sensors know few distances, so naming
// them by index pays, and indices are nearly linear in disparity, in which planes are planes.
// Within a bound, one value stands for several. docs/spec/codec.md §2.1.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class ValueTable {
 public:
  /// Whether a table pays for this frame, whose values it fills in: 0, then ascending, so that
  /// every reading is at most `bound_mm` from one of them.
  [[nodiscard]] bool choose(DepthView depth_mm, int bound_mm, std::vector<std::uint16_t>& values);

  /// Indices of the frame that was chosen for. Sizes must be equal.
  void map(DepthView depth_mm, ImageView<std::uint16_t> indices) const;

 private:
  void mark_values(DepthView depth_mm);
  void group(int bound_mm, std::vector<std::uint16_t>& values);

  std::vector<std::uint16_t> index_of_value_;  // while choosing: whether the value occurs
};

}  // namespace roomcast::codec
