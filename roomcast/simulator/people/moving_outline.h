// SPDX-License-Identifier: Apache-2.0
// Where a pixel of a layer may see two surfaces: on the outline of what moves, and where one part
// of it is before another. Elsewhere the pixel's centre says it all. Reused from frame to frame.
// Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/picture_tiles.h"

namespace roomcast::simulator {

class MovingOutline {
 public:
  /// Of pictures of this size. The tiles are those of a picture with twice the pixels in each
  /// direction.
  MovingOutline(int width, int height);

  /// `plate_z_m`: depth of what stands still.
  void find(const MovingLayer& layer, const Image<float>& plate_z_m);

  /// The layer's box and one pixel more on each side: nothing moving is seen outside.
  [[nodiscard]] const PixelBox& box() const { return box_; }
  enum class Sees : std::uint8_t { kStill, kMoving, kMaybeBoth };
  /// Inside the box.
  [[nodiscard]] Sees at(int x, int y) const { return sees_.at(x, y); }
  [[nodiscard]] const PictureTiles& fine_tiles() const { return fine_tiles_; }

 private:
  struct Range {  // of depth; nearest 0: something still is there too
    float nearest, farthest;
  };
  void gather_row(const MovingLayer& layer, const Image<float>& plate_z_m, int y,
                  std::vector<Range>& row) const;

  PixelBox box_;
  Image<Sees> sees_;
  std::vector<std::vector<Range>> rows_;  // three in turn: of each pixel and its two neighbours
  PictureTiles fine_tiles_;
};

}  // namespace roomcast::simulator
