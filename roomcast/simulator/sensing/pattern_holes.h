// SPDX-License-Identifier: Apache-2.0
// Pattern holes: structured light matches a window of its pattern, so readings come and go in
// patches, not pixel by pixel. A pixel has a reading where enough of its window returns light; a
// lost pixel in such a window gets its neighbour's depth. The threshold varies smoothly over the
// picture, because the pattern's contrast does (ours). Window of 9 pixels: Konolige and Mihelich,
// ROS wiki 2010. A function of (key, picture).
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::simulator {

inline constexpr int kPatternReach_px = 4;  // from the window's middle

/// `depth_mm`: readings pixel by pixel, 0 for none; replaced.
void match_by_patches(std::uint32_t key, ImageView<std::uint16_t> depth_mm);

}  // namespace roomcast::simulator
