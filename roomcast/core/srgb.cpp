// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/srgb.h"

#include <cmath>
#include <cstddef>

namespace roomcast {

float linear_from_level(float level) {
  const float s = level / 255.0F;
  return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
}

float level_from_linear(float linear) {
  const float s =
      linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
  return 255.0F * s;
}

std::array<float, 256> linear_levels() {
  std::array<float, 256> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i] = linear_from_level(static_cast<float>(i));
  return levels;
}

}  // namespace roomcast
