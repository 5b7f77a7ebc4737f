// SPDX-License-Identifier: Apache-2.0
// Which triangles separate the corners of a cube that are inside a surface from those outside, for
// each of the 256 cases of marching cubes (Lorensen & Cline 1987). The table is derived, not
// written down: on every face, each run of inside corners is cut off by one segment, and the
// segments of the six faces form closed loops. Two cubes that share a face cut it alike, so the
// surface has no cracks. Thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace roomcast::model {

/// Corner i is at (i & 1, i >> 1 & 1, i >> 2). Edge 4 * axis + n begins at the n-th of the corners
/// whose coordinate on that axis is 0, and goes along the axis.
struct CubeEdge {
  int corner = 0, axis = 0;
};
[[nodiscard]] CubeEdge cube_edge(int edge);

/// Triangles of edges, counter-clockwise as seen from outside.
using CubeCase = std::vector<std::array<std::uint8_t, 3>>;

/// Bit i of the index says whether corner i is inside.
[[nodiscard]] const std::array<CubeCase, 256>& cube_cases();

}  // namespace roomcast::model
