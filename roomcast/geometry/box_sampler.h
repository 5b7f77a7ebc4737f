// SPDX-License-Identifier: Apache-2.0
// Reads colour averaged over a square of N x N pixels centred anywhere between pixels: the exact
// area average, so that taking few pixels out of a large picture does not alias. N = 1 is bilinear
// interpolation. Positions are kept to 1/32 of a pixel. Thread-safe (no state).
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast {

inline constexpr int kLargestBox = 8;

/// Samples a row of positions: color[i] at (u[i], v[i]) where take[i] is not 0, black elsewhere.
/// Positions must lie in the picture (-0.5 <= u <= width - 0.5); squares that reach over its border
/// are moved inside.
using SampleRow = void (*)(ColorView picture, const float* u, const float* v,
                           const std::uint8_t* take, int count, Rgb8* color);

/// For squares of `size` pixels; sizes above kLargestBox, and above what fits into the picture, are
/// reduced. The picture must be at least 2 pixels wide and high.
[[nodiscard]] SampleRow box_sampler(int size, int picture_width, int picture_height);

}  // namespace roomcast
