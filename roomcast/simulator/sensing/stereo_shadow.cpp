// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/stereo_shadow.h"

#include <algorithm>
#include <limits>

namespace roomcast::simulator {

void take_stereo_shadow(DepthView clean_mm, float focal_px, float baseline_mm,
                        ImageView<std::uint16_t> depth_mm) {
  constexpr float kTouching_px = 0.75F;  // neighbouring disparities without a step differ by less
  for (int y = 0; y < clean_mm.height; ++y) {
    float leftmost = std::numeric_limits<float>::infinity();  // in the right picture, so far
    for (int x = clean_mm.width - 1; x >= 0; --x) {
      const std::uint16_t z_mm = clean_mm.at(x, y);
      if (z_mm == 0) continue;
      const float in_right =
          static_cast<float>(x) - focal_px * baseline_mm / static_cast<float>(z_mm);
      if (in_right > leftmost + kTouching_px || in_right < 0.0F) depth_mm.at(x, y) = 0;
      leftmost = std::min(leftmost, in_right);
    }
  }
}

}  // namespace roomcast::simulator
