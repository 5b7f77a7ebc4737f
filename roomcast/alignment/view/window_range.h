// SPDX-License-Identifier: Apache-2.0
// The nearest and the farthest reading in a square window around every pixel. Plain loops: van
// Herk's running extremum does not pay off at these window sizes. Metres; 0 = no reading.
// Thread-safe (no state).
#pragma once

#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct WindowRange {
  Image<float> nearest_m;   // kNothing_m where the window has no reading
  Image<float> farthest_m;  // 0 where the window has no reading
  MaskImage complete;       // 255 where every pixel of the window has a reading
};

inline constexpr float kNothing_m = 1e3F;

/// Windows of 2 * reach + 1 pixels; those at the border are never complete.
[[nodiscard]] WindowRange window_range(const Image<float>& z_m, int reach);

}  // namespace roomcast::alignment
