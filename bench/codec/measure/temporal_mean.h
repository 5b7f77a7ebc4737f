// SPDX-License-Identifier: Apache-2.0
// Colour with the sensor's noise taken out, as a reference where no clean colour is known: for each
// pixel the mean over seven frames, three before and three after, of what is near its own colour.
// It looks ahead, which no encoder of a live picture may. Single-threaded.
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Frames before and after the one that is cleaned.
inline constexpr int kMeanReach = 3;

struct SeenColor {
  ColorView color;
  MaskView seen;
};

/// `around` are neighbouring frames in any order; `frame` itself need not be among them. Sizes must
/// be equal. Where `frame` is not seen, `out` is black.
void temporal_mean(const SeenColor& frame, std::span<const SeenColor> around, ColorImage& out);

}  // namespace roomcast::bench
