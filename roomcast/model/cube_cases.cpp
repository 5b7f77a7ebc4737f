// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/cube_cases.h"

#include "roomcast/core/assert.h"

namespace roomcast::model {
namespace {

constexpr int kNone = -1;

bool is_inside(int cube, int corner) {
  return (cube >> corner & 1) != 0;
}

/// The edge between two neighbouring corners.
int edge_between(int a, int b) {
  const int low = a & b, axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  for (int edge = 4 * axis; edge < 4 * axis + 4; ++edge)
    if (cube_edge(edge).corner == low) return edge;
  return kNone;
}

/// The corners of a face, counter-clockwise as seen from outside the cube.
std::array<int, 4> face_corners(int axis, bool far) {
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const int base = far ? 1 << axis : 0;
  if (far) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

/// For each crossed edge the one that follows in its loop.
using NextEdges = std::array<int, 12>;

void add_segments(int cube, const std::array<int, 4>& corners, NextEdges& next) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    if (!is_inside(cube, corners[i]) || is_inside(cube, corners[before])) continue;
    std::size_t last = i;  // of the run that begins here
    while (is_inside(cube, corners[(last + 1) % 4])) last = (last + 1) % 4;
    const int enters = edge_between(corners[before], corners[i]);
    const int leaves = edge_between(corners[last], corners[(last + 1) % 4]);
    next[static_cast<std::size_t>(enters)] = leaves;
  }
}

CubeCase derive(int cube) {
  NextEdges next;
  next.fill(kNone);
  for (int axis = 0; axis < 3; ++axis) {
    add_segments(cube, face_corners(axis, false), next);
    add_segments(cube, face_corners(axis, true), next);
  }
  CubeCase triangles;
  for (int first = 0; first < 12; ++first) {
    std::vector<std::uint8_t> loop;
    for (int edge = first; next[static_cast<std::size_t>(edge)] != kNone;) {
      loop.push_back(static_cast<std::uint8_t>(edge));
      const int following = next[static_cast<std::size_t>(edge)];
      next[static_cast<std::size_t>(edge)] = kNone;
      edge = following;
    }
    for (std::size_t i = 2; i < loop.size(); ++i)
      triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return triangles;
}

}  // namespace

CubeEdge cube_edge(int edge) {
  ROOMCAST_ASSERT(edge >= 0 && edge < 12);
  const int axis = edge / 4, number = edge % 4;
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  return {((number & 1) != 0 ? u : 0) | ((number & 2) != 0 ? v : 0), axis};
}

const std::array<CubeCase, 256>& cube_cases() {
  static const std::array<CubeCase, 256> kCases = [] {
    std::array<CubeCase, 256> cases;
    for (int cube = 0; cube < 256; ++cube) cases[static_cast<std::size_t>(cube)] = derive(cube);
    return cases;
  }();
  return kCases;
}

}  // namespace roomcast::model
