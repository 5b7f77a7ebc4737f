// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/cube_cases.h"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace roomcast::model {
namespace {

bool is_crossed(int cube, int edge) {
  const CubeEdge e = cube_edge(edge);
  return (cube >> e.corner & 1) != (cube >> (e.corner | 1 << e.axis) & 1);
}

TEST(CubeCases, edges_are_the_twelve_of_a_cube) {
  std::set<std::pair<int, int>> edges;
  for (int i = 0; i < 12; ++i) {
    const CubeEdge edge = cube_edge(i);
    EXPECT_EQ(edge.corner >> edge.axis & 1, 0);
    edges.insert({edge.corner, edge.axis});
  }
  EXPECT_EQ(edges.size(), 12u);
}

TEST(CubeCases, nothing_is_drawn_where_all_corners_are_on_one_side) {
  EXPECT_TRUE(cube_cases()[0].empty());
  EXPECT_TRUE(cube_cases()[255].empty());
}

TEST(CubeCases, triangles_use_exactly_the_crossed_edges) {
  for (int cube = 0; cube < 256; ++cube) {
    std::set<int> used;
    for (const auto& triangle : cube_cases()[static_cast<std::size_t>(cube)])
      used.insert(triangle.begin(), triangle.end());
    for (int edge = 0; edge < 12; ++edge)
      EXPECT_EQ(used.contains(edge), is_crossed(cube, edge)) << cube << " " << edge;
  }
}

/// The border of the triangles of a case: lines that only one triangle has. They lie on faces.
TEST(CubeCases, each_crossed_edge_is_on_one_line_in_and_one_out) {
  for (int cube = 0; cube < 256; ++cube) {
    std::map<std::pair<int, int>, int> lines;
    for (const auto& t : cube_cases()[static_cast<std::size_t>(cube)]) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        ++lines[{a, b}];
        --lines[{b, a}];
      }
    }
    std::map<int, int> out, in;
    for (const auto& [line, count] : lines) {
      EXPECT_LE(count, 1);
      if (count == 1) ++out[line.first], ++in[line.second];
    }
    for (int edge = 0; edge < 12; ++edge) {
      EXPECT_EQ(out[edge], is_crossed(cube, edge) ? 1 : 0) << cube;
      EXPECT_EQ(in[edge], is_crossed(cube, edge) ? 1 : 0) << cube;
    }
  }
}

}  // namespace
}  // namespace roomcast::model
