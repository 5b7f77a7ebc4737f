// SPDX-License-Identifier: Apache-2.0
// Angle arithmetic in radians, and the easing curve of movements.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::simulator {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// The signed difference, the shorter way round: -pi..pi.
[[nodiscard]] inline float angle_between(float from_rad, float to_rad) {
  return std::remainder(to_rad - from_rad, 2.0F * kPi);
}

/// Eases 0..1 with zero speed at both ends; `share` is clamped to 0..1.
[[nodiscard]] inline float smooth_step(float share) {
  const float t = std::clamp(share, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

}  // namespace roomcast::simulator
