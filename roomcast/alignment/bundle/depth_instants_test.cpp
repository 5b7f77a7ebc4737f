// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/depth_instants.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

constexpr int kSide = 32;

/// A wall 3 m ahead, and a square at 2 m whose left edge is at `left`.
DepthImage wall_with_square(int left) {
  DepthImage picture(kSide, kSide, 3000);
  for (int y = 8; y < 24; ++y) {
    for (int x = left; x < left + 12 && x < kSide; ++x) picture.at(x, y) = 2000;
  }
  return picture;
}

std::size_t moving_blocks(const DepthInstant& instant) {
  std::size_t count = 0;
  for (int y = 0; y < instant.moving.height(); ++y) {
    for (int x = 0; x < instant.moving.width(); ++x) count += instant.moving.at(x, y) != 0;
  }
  return count;
}

std::vector<double> times_of(std::size_t count) {
  std::vector<double> times_s;
  for (std::size_t i = 0; i < count; ++i) times_s.push_back(0.1 * static_cast<double>(i));
  return times_s;
}

TEST(DepthInstants, tell_what_moves_from_what_is_behind_it) {
  std::vector<DepthImage> pictures;
  for (const int left : {0, 12, 20, 12}) pictures.push_back(wall_with_square(left));
  const auto instants = depth_instants(pictures, times_of(4));
  ASSERT_EQ(instants.size(), 4u);
  EXPECT_EQ(instants[1].time_s, 0.1);
  EXPECT_EQ(instants[1].depth_mm.width(), kSide / kInstantBlock);
  EXPECT_NE(instants[1].moving.at(4, 4), 0);  // inside the square
  EXPECT_EQ(instants[1].depth_mm.at(4, 4), 2000);
  EXPECT_EQ(instants[1].moving.at(1, 4), 0);  // where it was before
  EXPECT_EQ(instants[1].depth_mm.at(1, 4), 3000);
}

TEST(DepthInstants, what_stands_still_does_not_move) {
  const std::vector<DepthImage> pictures(4, wall_with_square(8));
  for (const DepthInstant& instant : depth_instants(pictures, times_of(4)))
    EXPECT_EQ(moving_blocks(instant), 0u);
}

TEST(DepthInstants, blocks_with_few_readings_have_none) {
  DepthImage picture(kSide, kSide, 3000);
  for (int y = 0; y < kInstantBlock; ++y) {
    for (int x = 0; x < 3; ++x) picture.at(x, y) = 0;  // three quarters of the first block
  }
  const auto instants = depth_instants(std::vector{picture}, times_of(1));
  EXPECT_EQ(instants[0].depth_mm.at(0, 0), 0);
  EXPECT_EQ(instants[0].depth_mm.at(1, 0), 3000);
}

TEST(DepthInstants, none_of_no_pictures) {
  EXPECT_TRUE(depth_instants({}, {}).empty());
}

}  // namespace
}  // namespace roomcast::alignment
