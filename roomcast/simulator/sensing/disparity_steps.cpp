// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/disparity_steps.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {

std::uint16_t DisparitySteps::rounded_mm(std::uint16_t depth_mm) const {
  if (depth_mm == 0) return 0;
  const float at_one_step_mm = focal_px * baseline_mm / step_px;
  const float steps = std::max(1.0F, std::round(at_one_step_mm / static_cast<float>(depth_mm)));
  return static_cast<std::uint16_t>(std::min(at_one_step_mm / steps + 0.5F, 65535.0F));
}

void round_to_disparity_steps(const DisparitySteps& steps, ImageView<std::uint16_t> depth_mm) {
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x)
      depth_mm.at(x, y) = steps.rounded_mm(depth_mm.at(x, y));
  }
}

}  // namespace roomcast::simulator
