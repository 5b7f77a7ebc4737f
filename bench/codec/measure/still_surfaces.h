// SPDX-License-Identifier: Apache-2.0
// Where nothing moves in a recording of a fixed sensor, the median of a pixel's readings is the
// best that is known of the true depth. Millimetres.
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Readings of a still surface are within this share of their median's distance.
inline constexpr double kStillShare = 0.05;

/// The median of each pixel's readings over all `frames` (of one size), 0 where the pixel is not
/// still: with readings in fewer than 90 % of the frames, or fewer than 90 % of its readings within
/// kStillShare of the median. Empty without frames.
[[nodiscard]] DepthImage median_of_still(std::span<const DepthView> frames);

}  // namespace roomcast::bench
