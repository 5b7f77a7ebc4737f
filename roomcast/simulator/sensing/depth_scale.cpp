// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_scale.h"

#include <algorithm>

namespace roomcast::simulator {

void apply_depth_scale(double depth_scale, ImageView<std::uint16_t> depth_mm) {
  const auto factor = static_cast<float>(1.0 / depth_scale);
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      std::uint16_t& at = depth_mm.at(x, y);
      if (at == 0) continue;
      at = static_cast<std::uint16_t>(
          std::clamp(factor * static_cast<float>(at) + 0.5F, 1.0F, 65535.0F));
    }
  }
}

}  // namespace roomcast::simulator
