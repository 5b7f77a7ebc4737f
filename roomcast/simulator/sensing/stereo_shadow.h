// SPDX-License-Identifier: Apache-2.0
// Stereo shadow: surfaces that only the left camera of a stereo pair sees cannot be matched, so
// there is a strip without depth next to near objects. Depth is given for the left camera; the pair
// is rectified. Pure function.
#pragma once

#include "roomcast/core/image.h"

namespace roomcast::simulator {

/// Zeroes the readings of every pixel whose surface is hidden from the right camera by another
/// surface in the picture. `clean_mm`: true depth.
void take_stereo_shadow(DepthView clean_mm, float focal_px, float baseline_mm,
                        ImageView<std::uint16_t> depth_mm);

}  // namespace roomcast::simulator
