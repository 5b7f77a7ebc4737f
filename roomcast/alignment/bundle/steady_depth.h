// SPDX-License-Identifier: Apache-2.0
// The static part of a series of depth pictures: the median over time of every pixel that has a
// reading in more than half of the pictures, and a mask of the unsteady pixels. Unsteadiness is
// measured by the median absolute deviation, not by the standard deviation, so a person who crosses
// the view for a few frames has no effect. Millimetres. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct SteadyDepth {
  DepthImage depth_mm;  // 0 where there is no steady reading
  MaskImage moving;     // 255 where the readings disagree
};

/// `pictures_mm`: at least one, all of one size.
[[nodiscard]] SteadyDepth steady_depth(std::span<const DepthImage> pictures_mm);

}  // namespace roomcast::alignment
