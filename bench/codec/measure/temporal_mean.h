// SPDX-License-Identifier: Apache-2.0
// Temporally denoised colour, as a reference where no clean colour is known. Each pixel is the mean
// over seven frames, three before and three after, of the values near its own colour. The method
// looks ahead, which a live encoder cannot do. Single-threaded.
#pragma once

#include <span>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Number of frames used before and after the denoised frame.
inline constexpr int kMeanReach = 3;

struct SeenColor {
  ColorView color;
  MaskView seen;
};

/// `around` are the neighbouring frames in any order, with or without `frame` itself. The sizes
/// must be equal. Where `frame` is not seen, `out` is black.
void temporal_mean(const SeenColor& frame, std::span<const SeenColor> around, ColorImage& out);

}  // namespace roomcast::bench
