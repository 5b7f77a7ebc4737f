// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/window_range.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(WindowRange, finds_nearest_and_farthest_around) {
  Image<float> z_m(7, 7, 2.F);
  z_m.at(3, 3) = 1;
  z_m.at(5, 3) = 3;
  const WindowRange range = window_range(z_m, 1);
  EXPECT_EQ(range.nearest_m.at(4, 4), 1);
  EXPECT_EQ(range.farthest_m.at(4, 4), 3);
  EXPECT_EQ(range.nearest_m.at(1, 1), 2);
  EXPECT_EQ(range.farthest_m.at(1, 1), 2);
}

TEST(WindowRange, a_window_with_a_missing_reading_is_not_complete) {
  Image<float> z_m(7, 7, 2.F);
  z_m.at(3, 3) = 0;
  const WindowRange range = window_range(z_m, 1);
  EXPECT_EQ(range.complete.at(2, 2), 0);
  EXPECT_EQ(range.nearest_m.at(2, 2), 2);
  EXPECT_EQ(range.complete.at(5, 5), 255);
  EXPECT_EQ(range.complete.at(6, 6), 0) << "at the border";
}

TEST(WindowRange, says_where_there_is_nothing_at_all) {
  const WindowRange range = window_range(Image<float>(5, 5), 1);
  EXPECT_EQ(range.nearest_m.at(2, 2), kNothing_m);
  EXPECT_EQ(range.farthest_m.at(2, 2), 0);
}

}  // namespace
}  // namespace roomcast::alignment
