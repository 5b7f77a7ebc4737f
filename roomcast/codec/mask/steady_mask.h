// SPDX-License-Identifier: Apache-2.0
// Removes the flicker of a sensor's colour mask, for the encoder. Depth noise decides anew in every
// frame whether the colour camera sees a pixel; each change costs bits and is visible as flicker. A
// pixel changes after a number of consecutive frames that contradict the shown value: six at first,
// twice as many after each change, half as many after four seconds without contradiction. Hiding a
// pixel takes a second at most, showing it four frames: in doubt a pixel is shown, because the
// stream keeps its last colour, which is right for a background behind a passing object. Without a
// reading, the pixel keeps its value. Assumes about 30 frames a second. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class SteadyMask {
 public:
  /// Returns the steady mask of the next frame, 0 and 255; valid until the next call. Always the
  /// same size.
  MaskView update(MaskView seen, DepthView depth_mm);

 private:
  struct Pixel {
    std::uint8_t needed = 6;                 // consecutive frames needed for a change
    std::uint8_t against = 0, agreeing = 0;  // consecutive frames
  };
  static void step(Pixel& pixel, bool seen, std::uint8_t& shown);
  void begin(MaskView seen);

  MaskImage shown_;
  Image<Pixel> pixels_;
};

}  // namespace roomcast::codec
