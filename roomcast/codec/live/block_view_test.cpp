// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/block_view.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

// 3x2 blocks; the last column has 4 pixels, the last row 1.
constexpr int kGridWidth = 20, kGridHeight = 9;

TEST(BlockGrid, counts_blocks_that_extend_beyond_the_picture) {
  const BlockGrid grid(kGridWidth, kGridHeight);
  EXPECT_EQ(grid.wide, 3);
  EXPECT_EQ(grid.high, 2);
  EXPECT_EQ(grid.block_count(), 6U);
  EXPECT_EQ(grid.pixel_count(), 180U);
}

TEST(BlockGrid, visits_blocks_in_raster_order) {
  std::size_t next = 0;
  BlockGrid(kGridWidth, kGridHeight).for_each_block([&](const BlockView& here) {
    EXPECT_EQ(here.index(), next++);
  });
  EXPECT_EQ(next, 6U);
}

TEST(BlockView, all_blocks_together_visit_each_pixel_of_the_picture_once) {
  const BlockGrid grid(kGridWidth, kGridHeight);
  std::vector<int> visits(grid.pixel_count());
  grid.for_each_block([&](const BlockView& here) {
    here.for_each_pixel([&](const BlockPixel& p) {
      EXPECT_EQ(p.at, grid.pixel(p.x, p.y));
      EXPECT_EQ(p.k, static_cast<std::size_t>(p.y % kBlockSide * kBlockSide + p.x % kBlockSide));
      ++visits[p.at];
    });
  });
  EXPECT_EQ(visits, std::vector<int>(grid.pixel_count(), 1));
}

TEST(BlockView, has_the_size_of_the_part_inside_the_picture) {
  const BlockGrid grid(kGridWidth, kGridHeight);
  EXPECT_TRUE(BlockView(grid, 1, 0).is_whole());
  const BlockView corner(grid, 2, 1);
  EXPECT_EQ(corner.columns(), 4);
  EXPECT_EQ(corner.rows(), 1);
  EXPECT_FALSE(corner.is_whole());
  EXPECT_EQ(corner.row(0), grid.pixel(16, 8));
}

TEST(BlockView, has_the_neighbours_inside_the_picture) {
  const BlockGrid grid(kGridWidth, kGridHeight);
  const BlockView first(grid, 0, 0), last(grid, 2, 1);
  EXPECT_FALSE(first.has_left() || first.has_above());
  EXPECT_TRUE(first.has_right() && first.has_below());
  EXPECT_EQ(first.right(), 1U);
  EXPECT_EQ(first.below(), 3U);
  EXPECT_FALSE(last.has_right() || last.has_below());
  EXPECT_TRUE(last.has_left() && last.has_above());
  EXPECT_EQ(last.left(), 4U);
  EXPECT_EQ(last.above(), 2U);
}

}  // namespace
}  // namespace roomcast::codec
