// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/color_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

std::vector<nanoseconds> times(const std::vector<int>& ms) {
  std::vector<nanoseconds> all;
  for (const int m : ms) all.push_back(std::chrono::milliseconds(m));
  return all;
}

TEST(ColorPairs, the_nearest_colour_within_the_tolerance_is_taken) {
  const auto pairs =
      nearest_colors(times({0, 33, 66, 200}), times({5, 30, 90}), std::chrono::milliseconds(16));
  EXPECT_THAT(pairs, testing::ElementsAre(0, 1, std::nullopt, std::nullopt));
  EXPECT_THAT(nearest_colors(times({1}), {}, std::chrono::seconds(1)),
              testing::ElementsAre(std::nullopt));
}

TEST(ColorPairs, the_frame_rate_is_that_of_the_middle_gap) {
  EXPECT_EQ(median_gap(times({0, 33, 66, 900}), nanoseconds(1)), std::chrono::milliseconds(33));
  EXPECT_EQ(median_gap(times({7}), nanoseconds(1)), nanoseconds(1));
  EXPECT_DOUBLE_EQ(fps_of_gap(std::chrono::milliseconds(50)), 20);
  EXPECT_DOUBLE_EQ(fps_of_gap(nanoseconds(1)), 240);
  EXPECT_DOUBLE_EQ(fps_of_gap(nanoseconds(0)), 240);
}

}  // namespace
}  // namespace roomcast::recording
