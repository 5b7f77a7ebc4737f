// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/foreground_cells.h"

#include <gtest/gtest.h>

namespace roomcast::scene_flow {
namespace {

constexpr int kSide = 16;  // four cells

DepthImage wall_at(std::uint16_t depth_mm) {
  return {kSide, kSide, depth_mm};
}

/// A wall at 3 m before which something stands in the left half.
DepthImage with_thing_at(std::uint16_t depth_mm) {
  DepthImage picture = wall_at(3000);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide / 2; ++x) picture.at(x, y) = depth_mm;
  }
  return picture;
}

class Foreground : public ::testing::Test {
 protected:
  const CellDepths& find(const DepthImage& picture, int times = 1) {
    for (int i = 0; i < times; ++i) finder_.find(picture, cells_);
    return cells_;
  }

  ForegroundFinder finder_{kSide, kSide};
  CellDepths cells_;
};

TEST_F(Foreground, what_stands_before_the_wall_is_found) {
  find(wall_at(3000), 10);
  const CellDepths& cells = find(with_thing_at(2000));
  ASSERT_EQ(cells.width(), kSide / kCellPixels);
  EXPECT_EQ(cells.at(0, 0), 2000);
  EXPECT_EQ(cells.at(3, 3), 0);
  EXPECT_DOUBLE_EQ(finder_.share(), 0.5);
}

TEST_F(Foreground, noise_of_the_wall_is_not_foreground) {
  find(wall_at(3000), 10);
  EXPECT_EQ(find(wall_at(2940)).at(1, 1), 0);
}

TEST_F(Foreground, the_wall_behind_somebody_who_leaves_becomes_the_background) {
  find(with_thing_at(2000), 10);
  find(wall_at(3000), 3);
  EXPECT_EQ(find(with_thing_at(2000)).at(0, 0), 2000);
}

TEST_F(Foreground, what_is_seen_where_nothing_was_read_for_long_is_foreground) {
  find(wall_at(0), 20);
  EXPECT_EQ(find(with_thing_at(2000)).at(0, 0), 2000);
}

TEST_F(Foreground, a_short_lack_of_readings_changes_nothing) {
  find(wall_at(3000), 10);
  find(wall_at(0), 5);
  EXPECT_EQ(find(wall_at(3000)).at(0, 0), 0);
}

TEST_F(Foreground, what_stays_becomes_background_in_the_end) {
  find(wall_at(3000), 10);
  EXPECT_EQ(find(with_thing_at(2000), 100).at(0, 0), 2000);
  EXPECT_EQ(find(with_thing_at(2000), 100).at(0, 0), 0);
}

TEST_F(Foreground, the_limit_is_before_the_nearest_background_of_the_cell) {
  DepthImage step = wall_at(3000);
  step.at(0, 0) = 2500;
  find(step, 10);
  EXPECT_FLOAT_EQ(finder_.limits_mm().at(0, 0), 2500 - 75);
  EXPECT_FLOAT_EQ(finder_.limits_mm().at(1, 1), 3000 - 90);
}

TEST_F(Foreground, a_few_pixels_do_not_make_a_cell) {
  find(wall_at(3000), 10);
  DepthImage specks = wall_at(3000);
  for (int x = 0; x < 4; ++x) specks.at(x, 0) = 2000;
  EXPECT_EQ(find(specks).at(0, 0), 0);
}

}  // namespace
}  // namespace roomcast::scene_flow
