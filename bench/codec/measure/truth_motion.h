// SPDX-License-Identifier: Apache-2.0
// Which pixels move, as the true depth itself says; so that an error on what moves cannot hide
// behind the many pixels that stand still.
//   moving  the true depth changed since the previous frame by at least 60 mm/s (2 mm at 30 fps)
//   slow    else, the surface in the pixel changed its depth within the last half second
//   static  the rest
// A change of more than 20 mm from frame to frame is another surface that came into the pixel: it
// is moving in that frame, and what it uncovers or covers is static until it changes itself.
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

  /// The next frame's truth, always of the same size. In the first frame everything is static.
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
