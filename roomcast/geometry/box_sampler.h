// SPDX-License-Identifier: Apache-2.0
// Reads colour averaged over a square of N x N pixels with a sub-pixel centre. The average is the
// exact area average, so that sub-sampling a large picture does not alias. N = 1 is bilinear
// interpolation. Positions are rounded to 1/32 of a pixel. Thread-safe (no state).
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast {

inline constexpr int kLargestBox = 8;

/// Samples a row of positions: color[i] at (u[i], v[i]) where take[i] is not 0, black elsewhere.
/// Positions must be in the picture (-0.5 <= u <= width - 0.5); squares that cross its border are
/// shifted inside.
using SampleRow = void (*)(ColorView picture, const float* u, const float* v,
                           const std::uint8_t* take, int count, Rgb8* color);

/// For squares of `size` pixels; `size` is reduced to kLargestBox and to what fits into the
/// picture. The picture must be at least 2 pixels wide and high.
[[nodiscard]] SampleRow box_sampler(int size, int picture_width, int picture_height);

}  // namespace roomcast
