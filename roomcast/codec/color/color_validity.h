// SPDX-License-Identifier: Apache-2.0
// What of a frame's colour belongs to the depth that is shown. A live depth stream holds an edge
// still while the sensor's readings jump between the surfaces at its two sides, and registered
// colour jumps with them: it says something of the shown surface only where the reading lies on it.
// Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class ColorValidity {
 public:
  /// The next frame: depth as measured and as shown, and where colour is seen. Always the same
  /// size.
  void update(DepthView measured_mm, DepthView shown_mm, MaskView seen);

  /// The readings that lie on the shown surface; 0 elsewhere.
  [[nodiscard]] DepthView depth_mm() const { return depth_mm_; }
  /// `seen` at these; 0 elsewhere.
  [[nodiscard]] MaskView seen() const { return seen_; }
  /// The same, and `seen` where neither was there a reading nor is one shown: its colour is sent,
  /// too.
  [[nodiscard]] MaskView colored() const { return colored_; }

 private:
  DepthImage depth_mm_;
  MaskImage seen_, colored_;
};

}  // namespace roomcast::codec
