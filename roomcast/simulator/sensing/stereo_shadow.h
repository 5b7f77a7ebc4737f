// SPDX-License-Identifier: Apache-2.0
// What only the left camera of a stereo pair sees has no partner to be matched with: beside near
// things lies a strip without depth. The left camera is the one that depth is given for; the pair
// is rectified. Pure function.
#pragma once

#include "roomcast/core/image.h"

namespace roomcast::simulator {

/// Zeroes the readings of every pixel whose surface (`clean_mm`: what is really there) is hidden
/// from the right camera by something else in the picture.
void take_stereo_shadow(DepthView clean_mm, float focal_px, float baseline_mm,
                        ImageView<std::uint16_t> depth_mm);

}  // namespace roomcast::simulator
