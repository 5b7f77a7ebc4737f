// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/pattern_holes.h"

#include <gtest/gtest.h>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

/// A wall of which each pixel is lost with this probability.
DepthImage wall_with_losses(float lost) {
  DepthImage depth_mm(160, 120);
  for (std::uint32_t i = 0; i < 160 * 120; ++i)
    depth_mm.data()[i] = unit_from_hash(hash_of(3, i)) < lost ? 0 : 2000;
  return depth_mm;
}

double share_of_readings(const DepthImage& depth_mm) {
  int count = 0;
  for (int i = 0; i < 160 * 120; ++i) count += depth_mm.data()[i] != 0;
  return count / (160.0 * 120.0);
}

/// The share of horizontal neighbours of which one is lost and the other is not.
double share_of_borders(const DepthImage& depth_mm) {
  int count = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 1; x < 160; ++x) count += (depth_mm.at(x, y) == 0) != (depth_mm.at(x - 1, y) == 0);
  }
  return count / (159.0 * 120.0);
}

TEST(PatternHoles, losses_become_patches) {
  DepthImage depth_mm = wall_with_losses(0.5F);
  EXPECT_GT(share_of_borders(depth_mm), 0.4);
  match_by_patches(1, depth_mm.view());
  EXPECT_LT(share_of_borders(depth_mm), 0.12);
  EXPECT_GT(share_of_readings(depth_mm), 0.2);
  EXPECT_LT(share_of_readings(depth_mm), 0.8);
}

TEST(PatternHoles, few_losses_are_filled_and_many_leave_nothing) {
  DepthImage few = wall_with_losses(0.05F), many = wall_with_losses(0.97F);
  match_by_patches(1, few.view());
  match_by_patches(1, many.view());
  EXPECT_GT(share_of_readings(few), 0.99);
  EXPECT_EQ(share_of_readings(many), 0);
}

TEST(PatternHoles, a_whole_picture_stays_as_it_is) {
  DepthImage depth_mm = wall_with_losses(0);
  depth_mm.at(50, 50) = 1234;
  const DepthImage before = depth_mm;
  match_by_patches(1, depth_mm.view());
  EXPECT_EQ(depth_mm, before);
}

}  // namespace
}  // namespace roomcast::simulator
