// SPDX-License-Identifier: Apache-2.0
// PictureTiles: a selection of square tiles of a picture. Single-threaded.
#pragma once

#include <algorithm>
#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/simulator/tracing/placed_camera.h"

namespace roomcast::simulator {

class PictureTiles {
 public:
  /// Starts with no tile selected; tiles are `side` pixels wide.
  PictureTiles(int width, int height, int side)
      : side_(side), wanted_((width + side - 1) / side, (height + side - 1) / side) {}

  void clear() { std::fill_n(wanted_.data(), wanted_.view().pixel_count(), std::uint8_t{0}); }
  /// Selects the tile that contains this pixel.
  void want(int x, int y) { wanted_.at(x / side_, y / side_) = 1; }

  /// Requires a box that is not empty and inside the picture.
  [[nodiscard]] bool any_in(const PixelBox& box) const {
    for (int y = box.top / side_; y <= (box.bottom - 1) / side_; ++y) {
      for (int x = box.left / side_; x <= (box.right - 1) / side_; ++x) {
        if (wanted_.at(x, y) != 0) return true;
      }
    }
    return false;
  }

 private:
  int side_;
  Image<std::uint8_t> wanted_;
};

}  // namespace roomcast::simulator
