// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/steady_depth.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/bundle/sample_stack.h"
#include "roomcast/alignment/bundle/steady_color.h"

namespace roomcast::alignment {
namespace {

/// The result for a single pixel with these readings over time.
SteadyDepth of_pixel(const std::vector<std::uint16_t>& readings_mm) {
  std::vector<DepthImage> pictures;
  for (const std::uint16_t mm : readings_mm) pictures.emplace_back(1, 1, mm);
  return steady_depth(pictures);
}

TEST(SampleStack, sorts_every_pixel_for_itself) {
  SampleStack<int> stack(4, 2);
  const int samples[4][2] = {{9, 1}, {2, 3}, {7, 8}, {4, 2}};
  for (std::size_t i = 0; i < 4; ++i) std::copy_n(samples[i], 2, stack.picture(i).begin());
  stack.sort();
  const int sorted[4][2] = {{2, 1}, {4, 2}, {7, 3}, {9, 8}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(stack.picture(i)[0], sorted[i][0]);
    EXPECT_EQ(stack.picture(i)[1], sorted[i][1]);
  }
}

TEST(SteadyDepth, takes_the_median_of_the_readings_there_are) {
  EXPECT_EQ(of_pixel({2000, 0, 2004, 2002, 0}).depth_mm.at(0, 0), 2002);
}

TEST(SteadyDepth, leaves_out_a_pixel_that_is_missing_half_of_the_time) {
  EXPECT_EQ(of_pixel({2000, 0, 2004, 0}).depth_mm.at(0, 0), 0);
}

TEST(SteadyDepth, somebody_who_crosses_the_view_costs_nothing) {
  const auto steady = of_pixel({3000, 3002, 900, 950, 3001, 3000, 2999});
  EXPECT_EQ(steady.depth_mm.at(0, 0), 3000);
  EXPECT_EQ(steady.moving.at(0, 0), 0);
}

TEST(SteadyDepth, marks_what_does_not_hold_still) {
  const auto moving = of_pixel({3000, 2500, 1900, 2800, 2100, 1500, 2600});
  EXPECT_EQ(moving.depth_mm.at(0, 0), 0);
  EXPECT_EQ(moving.moving.at(0, 0), 255);
}

TEST(SteadyDepth, a_single_picture_is_steady) {
  EXPECT_EQ(of_pixel({1234}).depth_mm.at(0, 0), 1234);
}

TEST(SteadyColor, shows_no_ghost_of_what_passed) {
  std::vector<ColorImage> pictures(5, ColorImage(3, 2, {100, 110, 120}));
  pictures[1] = ColorImage(3, 2, {0, 255, 7});
  EXPECT_EQ(steady_color(pictures), pictures[0]);
}

}  // namespace
}  // namespace roomcast::alignment
