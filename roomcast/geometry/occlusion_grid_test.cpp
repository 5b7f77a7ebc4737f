// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/occlusion_grid.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

struct Pixel {
  float u, v, z_m;
};

/// Enters `pixels` and returns the nearest z around each.
std::vector<float> nearest_around(OcclusionGrid& grid, const std::vector<Pixel>& pixels) {
  std::vector<std::int32_t> cells(pixels.size());
  grid.clear();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    grid.splat_row(&pixels[i].u, &pixels[i].v, &pixels[i].z_m, 1, &cells[i]);
  }
  grid.finish();
  std::vector<float> nearest;
  for (const std::int32_t cell : cells) nearest.push_back(grid.nearest_m(cell));
  return nearest;
}

TEST(OcclusionGrid, the_nearest_surface_of_a_cell_wins_in_any_order) {
  OcclusionGrid grid(64, 48, 4);
  EXPECT_EQ(nearest_around(grid, {{10, 10, 2}, {10, 10, 1}}), (std::vector<float>{1, 1}));
  EXPECT_EQ(nearest_around(grid, {{10, 10, 1}, {10, 10, 2}}), (std::vector<float>{1, 1}));
}

TEST(OcclusionGrid, a_surface_reaches_one_cell_further_in_every_direction) {
  OcclusionGrid grid(64, 48, 4);
  for (const float du : {-4.0F, 0.0F, 4.0F}) {
    for (const float dv : {-4.0F, 0.0F, 4.0F}) {
      EXPECT_EQ(nearest_around(grid, {{20, 20, 1}, {20 + du, 20 + dv, 2}})[1], 1);
    }
  }
}

TEST(OcclusionGrid, a_surface_does_not_reach_two_cells_further) {
  OcclusionGrid grid(64, 48, 4);
  EXPECT_EQ(nearest_around(grid, {{20, 20, 1}, {28, 20, 2}})[1], 2);
  EXPECT_EQ(nearest_around(grid, {{20, 20, 1}, {20, 12, 2}})[1], 2);
}

TEST(OcclusionGrid, without_depth_everything_is_nearer) {
  OcclusionGrid grid(64, 48, 4);
  EXPECT_EQ(nearest_around(grid, {{0, 0, 0}, {0, 0, 3}}), (std::vector<float>{-INFINITY, 3}));
}

TEST(OcclusionGrid, the_outermost_positions_of_the_picture_have_cells) {
  for (const int cell_size : {1, 3, 4, 100}) {
    OcclusionGrid grid(64, 48, cell_size);
    EXPECT_EQ(nearest_around(grid, {{-0.5F, -0.5F, 1}})[0], 1);
    EXPECT_EQ(nearest_around(grid, {{63.5F, 47.5F, 1}})[0], 1);
  }
}

TEST(OcclusionGrid, clear_forgets) {
  OcclusionGrid grid(64, 48, 4);
  nearest_around(grid, {{10, 10, 1}});
  EXPECT_EQ(nearest_around(grid, {{10, 10, 5}})[0], 5);
}

}  // namespace
}  // namespace roomcast
