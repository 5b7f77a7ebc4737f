// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/depth_factor.h"

#include <algorithm>

namespace roomcast {

void multiply_depth(ImageView<std::uint16_t> depth_mm, double factor) {
  const auto by = static_cast<float>(factor);
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      std::uint16_t& reading = depth_mm.at(x, y);
      reading =
          static_cast<std::uint16_t>(std::min(by * static_cast<float>(reading) + 0.5F, 65535.0F));
    }
  }
}

}  // namespace roomcast
