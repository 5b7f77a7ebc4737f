// SPDX-License-Identifier: Apache-2.0
// Classifies pixels by the motion of the true depth, so that errors on moving surfaces are not
// hidden by the many static pixels.
//   moving  the true depth changed since the previous frame by at least 60 mm/s (2 mm at 30 fps)
//   slow    else, the surface in the pixel changed its depth within the last half second
//   static  the rest
// A change of more than 20 mm from frame to frame means that another surface came into the pixel:
// the pixel is moving in that frame, and afterwards static until its depth changes again.
// Millimetres. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::bench {

enum class Motion : std::uint8_t { kStatic, kSlow, kMoving };
inline constexpr int kMotionCount = 3;

class TruthMotion {
 public:
  explicit TruthMotion(double fps);

  /// Adds the next frame's true depth; the size must not change. In the first frame all pixels are
  /// static.
  void add(DepthView truth_mm);

  [[nodiscard]] ImageView<const Motion> motion() const { return motion_; }

 private:
  [[nodiscard]] Motion step(int change_mm, std::uint16_t& frames_still) const;

  int moving_step_mm_;
  std::uint16_t slow_frames_;
  DepthImage previous_mm_;
  Image<std::uint16_t> frames_still_;  // since the surface last changed its depth
  Image<Motion> motion_;
};

}  // namespace roomcast::bench
