// SPDX-License-Identifier: Apache-2.0
// Takes the flicker out of a sensor's colour mask, for the encoder. At the edges of what the colour
// camera sees, depth noise decides anew in every frame whether a pixel is seen; each change costs
// bits and disturbs the eye. A pixel that is hidden is so at once. To be seen again it must be seen
// in as many frames in a row as it has shown to be restless: one at first, twice as many after each
// return, at most half a second; calm for three seconds, it starts anew. Where a reading is
// missing, what was known stays. Frames are thought to come at about 30 a second. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class SteadyMask {
 public:
  /// The steady mask of the next frame, 0 and 255; valid until the next call. Always the same size.
  MaskView update(MaskView seen, DepthView depth_mm);

 private:
  struct Pixel {
    std::uint8_t needed = 1;  // frames in a row that it takes to be seen again
    std::uint8_t run = 0;     // frames in a row that it was seen while hidden
    std::uint8_t calm = 0;    // frames since it last changed
  };
  static void step(Pixel& pixel, bool seen, std::uint8_t& shown);

  MaskImage shown_;
  Image<Pixel> pixels_;
};

}  // namespace roomcast::codec
