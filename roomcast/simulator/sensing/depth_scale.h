// SPDX-License-Identifier: Apache-2.0
// Depth scale: a sensor whose readings are all too long or too short by one factor, as by a wrong
// baseline or modulation frequency. Three Kinects v1 of one recorded room differed by 4 % (kinects3
// of the shared data). Pure functions.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::simulator {

inline constexpr double kMaxDepthScaleError = 0.05;

/// Replaces true depth by readings: true depth = `depth_scale` * reading; 0 stays 0.
void apply_depth_scale(double depth_scale, ImageView<std::uint16_t> depth_mm);

}  // namespace roomcast::simulator
