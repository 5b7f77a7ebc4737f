// SPDX-License-Identifier: Apache-2.0
// What stands still in a series of colour pictures: the median over time of every channel of every
// pixel. Unlike a mean it shows no ghost of somebody who crosses the view. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::alignment {

/// One picture at least, all of one size.
[[nodiscard]] ColorImage steady_color(std::span<const ColorImage> pictures);

}  // namespace roomcast::alignment
