// SPDX-License-Identifier: Apache-2.0
// Selects the colour of a frame that belongs to the depth that is shown. A live depth stream keeps
// an edge fixed while the sensor's readings jump between the surfaces at its two sides, and
// registered colour jumps with the readings. Colour is valid only where the reading is on the shown
// surface. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class ColorValidity {
 public:
  /// Takes the next frame: measured depth, shown depth, and the mask of seen colour. Always the
  /// same size.
  void update(DepthView measured_mm, DepthView shown_mm, MaskView seen);

  /// The readings on the shown surface; 0 elsewhere.
  [[nodiscard]] DepthView depth_mm() const { return depth_mm_; }
  /// `seen` at these readings; 0 elsewhere.
  [[nodiscard]] MaskView seen() const { return seen_; }
  /// The same, and `seen` where depth has neither a measured nor a shown reading: that colour is
  /// sent, too.
  [[nodiscard]] MaskView colored() const { return colored_; }

 private:
  DepthImage depth_mm_;
  MaskImage seen_, colored_;
};

}  // namespace roomcast::codec
