// SPDX-License-Identifier: Apache-2.0
// The foreground of one sensor's depth pictures, in cells of 4x4 pixels: what stands before the
// background that the sensor has read at the same pixels. Single-threaded; allocates only when it
// is made.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::scene_flow {

/// Width and height of a cell. The last cells of a row and of a column may be narrower.
inline constexpr int kCellPixels = 4;

/// The cells along so many pixels.
constexpr int cells_along(int pixels) {
  return (pixels + kCellPixels - 1) / kCellPixels;
}

/// Mean depth of the foreground in each cell, in millimetres; 0 where fewer than five of its 16
/// pixels are foreground, or it is farther than kMaxDepth_mm.
inline constexpr int kMaxDepth_mm = 32'000;
using CellDepths = Image<std::int16_t>;

class ForegroundFinder {
 public:
  /// For pictures of this size.
  ForegroundFinder(int width, int height);

  /// Takes the sensor's next picture, of the size given above.
  void find(DepthView depth_mm, CellDepths& cells);

  /// By cell: surfaces nearer than this, in millimetres, stand before the background everywhere in
  /// the cell.
  [[nodiscard]] const Image<float>& limits_mm() const { return limits_mm_; }
  /// Cells with foreground in the newest picture.
  [[nodiscard]] int cell_count() const { return cell_count_; }
  /// Share of the newest picture's readings that are foreground.
  [[nodiscard]] double share() const { return share_; }

 private:
  struct Pixel {
    std::uint16_t background_mm = 0;  // 0: unknown
    std::uint16_t candidate_mm = 0;   // kNothing: no reading
    std::uint8_t agreeing = 0;        // pictures in a row that agree with the candidate
  };
  [[nodiscard]] static bool is_foreground(Pixel& pixel, int reading_mm);

  Image<Pixel> pixels_;
  Image<float> limits_mm_;
  int cell_count_ = 0;
  double share_ = 0;
};

}  // namespace roomcast::scene_flow
