// SPDX-License-Identifier: Apache-2.0
// Angles, and the curve along which movements begin and end. Radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::simulator {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// The shorter way round, -pi..pi.
[[nodiscard]] inline float angle_between(float from_rad, float to_rad) {
  return std::remainder(to_rad - from_rad, 2.0F * kPi);
}

/// 0..1 with no jump in speed at either end; `share` is limited to 0..1.
[[nodiscard]] inline float smooth_step(float share) {
  const float t = std::clamp(share, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

}  // namespace roomcast::simulator
