// SPDX-License-Identifier: Apache-2.0
// Positions of the four quarters of each depth pixel in the colour picture: a quarter of a pixel
// from the pixel's centre, along the surface. For colour at twice the depth grid's resolution.
// Positions in colour pixels, z in metres. Thread-safe (no state).
#pragma once

#include <cstddef>
#include <vector>

namespace roomcast {

/// A frame's depth pixels projected into the colour camera, row by row; z_m is 0 where there is
/// none.
struct ProjectedSurface {
  int width = 0, height = 0;
  const float* u = nullptr;
  const float* v = nullptr;
  const float* z_m = nullptr;
  /// Step between neighbours, in colour pixels, for pixels without a neighbour on the same surface.
  float spacing = 1;
  /// Limits of the colour picture; quarters are kept inside.
  float largest_u = 0, largest_v = 0;
};

/// One row of quarters, 2 * width of them.
struct QuarterRow {
  std::vector<float> u, v;
};

/// Finds the upper and lower quarters of row `y` of the surface. The vectors are resized as needed;
/// pixels without depth get the position of the picture's corner.
void find_quarters(const ProjectedSurface& surface, int y, QuarterRow& upper, QuarterRow& lower);

}  // namespace roomcast
