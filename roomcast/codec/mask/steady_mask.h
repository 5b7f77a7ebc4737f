// SPDX-License-Identifier: Apache-2.0
// Takes the flicker out of a sensor's colour mask, for the encoder. Depth noise decides anew in
// every frame whether the colour camera is thought to see a pixel; each change costs bits and
// disturbs the eye. A pixel changes when the sensor has said so in as many frames in a row as the
// pixel has shown to be restless: six at first, twice as many after each change, half as many again
// after four seconds without a word against what is shown. Hiding a pixel takes a second at most,
// showing it four frames: while in doubt it is shown, for the stream goes on with the colour that
// the pixel last had, which is right for a background that something passes before. Where a reading
// is missing, what was known stays. Frames are thought to come at about 30 a second.
// Single-threaded.
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
    std::uint8_t needed = 6;                 // frames in a row that a change takes
    std::uint8_t against = 0, agreeing = 0;  // frames in a row that said so
  };
  static void step(Pixel& pixel, bool seen, std::uint8_t& shown);
  void begin(MaskView seen);

  MaskImage shown_;
  Image<Pixel> pixels_;
};

}  // namespace roomcast::codec
