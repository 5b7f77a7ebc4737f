// SPDX-License-Identifier: Apache-2.0
// The static part of a series of colour pictures: the median over time of every channel of every
// pixel. Unlike a mean, it shows no ghost of a person who crosses the view. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::alignment {

/// `pictures`: at least one, all of one size.
[[nodiscard]] ColorImage steady_color(std::span<const ColorImage> pictures);

}  // namespace roomcast::alignment
