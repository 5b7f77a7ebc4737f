// SPDX-License-Identifier: Apache-2.0
// MovingOutline: finds the pixels of a layer that may see two surfaces: on the outline of moving
// things, and where one part occludes another. Elsewhere the pixel's centre suffices. Reused from
// frame to frame. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/picture_tiles.h"

namespace roomcast::simulator {

class MovingOutline {
 public:
  /// For pictures of this size. The tiles are those of a picture with twice the pixels in each
  /// direction.
  MovingOutline(int width, int height);

  /// `plate_z_m`: depth of the static scene.
  void find(const MovingLayer& layer, const Image<float>& plate_z_m);

  /// The layer's box plus one pixel on each side: nothing moving is visible outside.
  [[nodiscard]] const PixelBox& box() const { return box_; }
  enum class Sees : std::uint8_t { kStill, kMoving, kMaybeBoth };
  /// Valid inside the box.
  [[nodiscard]] Sees at(int x, int y) const { return sees_.at(x, y); }
  [[nodiscard]] const PictureTiles& fine_tiles() const { return fine_tiles_; }

 private:
  struct Range {  // depth range; nearest 0: the static scene is also visible
    float nearest, farthest;
  };
  void gather_row(const MovingLayer& layer, const Image<float>& plate_z_m, int y,
                  std::vector<Range>& row) const;

  PixelBox box_;
  Image<Sees> sees_;
  std::vector<std::vector<Range>> rows_;  // three, in turn: of a pixel and its two neighbours
  PictureTiles fine_tiles_;
};

}  // namespace roomcast::simulator
