// SPDX-License-Identifier: Apache-2.0
// Where the four quarters of each depth pixel lie in the colour picture: a quarter of a pixel
// beside the pixel's middle, along the surface. For colour at twice the depth grid's resolution.
// Positions in colour pixels, z in metres. Thread-safe (no state).
#pragma once

#include <cstddef>
#include <vector>

namespace roomcast {

/// A frame's depth pixels as the colour camera sees them, row by row; z_m is 0 where there is none.
struct ProjectedSurface {
  int width = 0, height = 0;
  const float* u = nullptr;
  const float* v = nullptr;
  const float* z_m = nullptr;
  /// Between neighbours, where none of them tells.
  float spacing = 1;
  /// The colour picture, beyond whose border no quarter lies.
  float largest_u = 0, largest_v = 0;
};

/// One row of quarters, 2 * width of them.
struct QuarterRow {
  std::vector<float> u, v;
};

/// Those of row `y` of the surface: the upper and the lower ones. Vectors are made large enough;
/// without depth they hold the picture's corner.
void find_quarters(const ProjectedSurface& surface, int y, QuarterRow& upper, QuarterRow& lower);

}  // namespace roomcast
