// SPDX-License-Identifier: Apache-2.0
// A depth sensor's noise by distance, learnt from its own frames: the standard deviation of the
// mean depth of a block of pixels. Noise is told from motion by second differences over three
// frames: a motion of constant speed leaves them 0, so that the law is learnt correctly even while
// the sensor is carried. Each distance keeps a running median, which blocks with people or outlines
// hardly change. Until a distance has been seen, its noise is that of a poor structured-light
// sensor, which grows with the square of the distance (Khoshelham & Elberink 2012). Millimetres.
// Single-threaded.
#pragma once

#include <array>
#include <span>

#include "roomcast/codec/live/depth_domain.h"

namespace roomcast::codec {

class NoiseLaw {
 public:
  /// Means of the same blocks in three consecutive frames, the newest first; 0 = unknown.
  struct ThreeFrames {
    std::span<const float> now_mm, before_mm, long_before_mm;
  };

  NoiseLaw();
  void learn(const ThreeFrames& blocks);

  [[nodiscard]] float sigma_mm(float depth_mm) const {
    return sigma_mm_[static_cast<std::size_t>(sigma_knot_of(static_cast<int>(depth_mm)))];
  }

 private:
  std::array<float, kSigmaKnotCount> sigma_mm_{};  // from a knot to the next
  int frames_ = 0;                                 // learnt from, at most kQuickFrames
};

}  // namespace roomcast::codec
