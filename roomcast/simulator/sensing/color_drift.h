// SPDX-License-Identifier: Apache-2.0
// ColorDrift: exposure and white balance that wander while a sensor runs, each sensor on its own,
// as automatic controls do. Smooth noise over scene time; the amounts are ours. A function of time.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/core/clock.h"

namespace roomcast::simulator {

struct ColorDrift {
  float exposure = 0, balance = 0;  // largest changes, as shares
  float period_s = 1;               // about, from one extreme to the other
  std::uint32_t key = 0;

  /// Factors of linear light, red first; 1 without drift.
  [[nodiscard]] std::array<float, 3> gains(nanoseconds scene_time) const;
};

}  // namespace roomcast::simulator
