// SPDX-License-Identifier: Apache-2.0
// The levels of sRGB in linear light, as glTF's colours of points are. Source: IEC 61966-2-1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace roomcast::recording {

/// 0..1, by level.
[[nodiscard]] inline std::array<float, 256> linear_levels() {
  std::array<float, 256> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double s = static_cast<double>(i) / 255;
    levels[i] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  }
  return levels;
}

/// The level nearest to `linear`; what is not within 0..1 is brought there.
[[nodiscard]] inline std::uint8_t level_of(float linear) {
  const double light = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

}  // namespace roomcast::recording
