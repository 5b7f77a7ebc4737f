// SPDX-License-Identifier: Apache-2.0
// Where the 8x8 blocks of a picture are: all index arithmetic of live depth. Blocks at the right
// and lower edge may extend beyond the picture; a view leaves out the pixels outside.
#pragma once

#include <algorithm>
#include <cstddef>

#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {

/// One pixel of a block.
struct BlockPixel {
  int x, y;        // in the picture
  std::size_t k;   // index in the block, row by row
  std::size_t at;  // index in the picture, row by row
};

class BlockView;

/// A picture of width x height pixels, divided into blocks.
struct BlockGrid {
  int width = 0, height = 0;
  int wide = 0, high = 0;  // blocks

  BlockGrid() = default;
  BlockGrid(int picture_width, int picture_height)
      : width(picture_width),
        height(picture_height),
        wide((picture_width + kBlockSide - 1) / kBlockSide),
        high((picture_height + kBlockSide - 1) / kBlockSide) {}

  [[nodiscard]] std::size_t pixel_count() const { return pixel(0, height); }
  [[nodiscard]] std::size_t block_count() const { return block(0, high); }
  /// Index of pixel (x, y), row by row.
  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  /// Index of block (bx, by), row by row.
  [[nodiscard]] std::size_t block(int bx, int by) const {
    return static_cast<std::size_t>(by) * static_cast<std::size_t>(wide) +
           static_cast<std::size_t>(bx);
  }
  /// Calls `what` with the view of each block, row by row.
  template <class Do>
  void for_each_block(Do&& what) const;
};

class BlockView {
 public:
  BlockView() = default;
  BlockView(const BlockGrid& grid, int bx, int by)
      : grid_(grid), bx_(bx), by_(by), index_(grid.block(bx, by)) {}

  /// Indices of the block and its neighbours among the picture's blocks.
  [[nodiscard]] std::size_t index() const { return index_; }
  [[nodiscard]] std::size_t left() const { return index_ - 1; }
  [[nodiscard]] std::size_t right() const { return index_ + 1; }
  [[nodiscard]] std::size_t above() const { return index_ - static_cast<std::size_t>(grid_.wide); }
  [[nodiscard]] std::size_t below() const { return index_ + static_cast<std::size_t>(grid_.wide); }
  [[nodiscard]] bool has_left() const { return bx_ > 0; }
  [[nodiscard]] bool has_right() const { return bx_ + 1 < grid_.wide; }
  [[nodiscard]] bool has_above() const { return by_ > 0; }
  [[nodiscard]] bool has_below() const { return by_ + 1 < grid_.high; }

  /// Size of the part inside the picture, pixels.
  [[nodiscard]] int columns() const { return std::min(kBlockSide, grid_.width - bx_ * kBlockSide); }
  [[nodiscard]] int rows() const { return std::min(kBlockSide, grid_.height - by_ * kBlockSide); }
  [[nodiscard]] bool is_whole() const { return columns() == kBlockSide && rows() == kBlockSide; }

  /// Index in the picture of the first pixel of the block's row y.
  [[nodiscard]] std::size_t row(int y) const {
    return grid_.pixel(bx_ * kBlockSide, by_ * kBlockSide + y);
  }
  /// Calls `what` with each pixel inside the picture, row by row.
  template <class Do>
  void for_each_pixel(Do&& what) const {
    const int wide = columns(), high = rows();
    for (int y = 0; y < high; ++y) {
      const std::size_t first = row(y);
      for (int x = 0; x < wide; ++x) {
        what(BlockPixel{bx_ * kBlockSide + x, by_ * kBlockSide + y,
                        static_cast<std::size_t>(y * kBlockSide + x),
                        first + static_cast<std::size_t>(x)});
      }
    }
  }

 private:
  BlockGrid grid_;
  int bx_ = 0, by_ = 0;
  std::size_t index_ = 0;
};

template <class Do>
void BlockGrid::for_each_block(Do&& what) const {
  for (int by = 0; by < high; ++by) {
    for (int bx = 0; bx < wide; ++bx) what(BlockView(*this, bx, by));
  }
}

}  // namespace roomcast::codec
