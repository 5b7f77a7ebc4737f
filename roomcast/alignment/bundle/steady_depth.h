// SPDX-License-Identifier: Apache-2.0
// What stands still in a series of depth pictures: the median over time of every pixel that has a
// reading in more than half of the pictures, and a mask of those that do not hold still. Unsteady
// is judged by the median absolute deviation, not by the standard deviation: somebody who crosses
// the view for a few frames then costs nothing. Millimetres. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct SteadyDepth {
  DepthImage depth_mm;  // 0 where there is no reading, or no steady one
  MaskImage moving;     // 255 where there are readings that do not agree
};

/// One picture at least, all of one size.
[[nodiscard]] SteadyDepth steady_depth(std::span<const DepthImage> pictures_mm);

}  // namespace roomcast::alignment
