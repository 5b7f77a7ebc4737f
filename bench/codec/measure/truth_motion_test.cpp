// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/truth_motion.h"

#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

/// The class of one pixel in each frame, from its true depths at 30 frames per second.
std::vector<Motion> motions(std::initializer_list<int> truth_mm) {
  TruthMotion truth(30);
  std::vector<Motion> motions;
  for (const int depth : truth_mm) {
    truth.add(DepthImage(1, 1, static_cast<std::uint16_t>(depth)));
    motions.push_back(truth.motion().at(0, 0));
  }
  return motions;
}

constexpr Motion kStatic = Motion::kStatic, kSlow = Motion::kSlow, kMoving = Motion::kMoving;

TEST(TruthMotion, unchanged_pixels_are_static) {
  EXPECT_EQ(motions({2000, 2000, 2000}), (std::vector{kStatic, kStatic, kStatic}));
}

TEST(TruthMotion, two_millimetres_a_frame_are_moving_and_one_is_slow) {
  EXPECT_EQ(motions({2000, 2002, 2003, 2001}), (std::vector{kStatic, kMoving, kSlow, kMoving}));
}

TEST(TruthMotion, at_fewer_frames_a_second_the_same_speed_takes_larger_steps) {
  TruthMotion truth(10);
  for (const std::uint16_t depth : {2000, 2005, 2011}) truth.add(DepthImage(1, 1, depth));
  EXPECT_EQ(truth.motion().at(0, 0), kMoving);
  truth.add(DepthImage(1, 1, 2016));
  EXPECT_EQ(truth.motion().at(0, 0), kSlow);
}

TEST(TruthMotion, a_drift_within_half_a_second_is_slow) {
  TruthMotion truth(30);
  truth.add(DepthImage(1, 1, 2000));
  for (int i = 0; i < 15; ++i) {
    truth.add(DepthImage(1, 1, 2001));
    ASSERT_EQ(truth.motion().at(0, 0), kSlow) << i;
  }
  truth.add(DepthImage(1, 1, 2001));
  EXPECT_EQ(truth.motion().at(0, 0), kStatic);
}

TEST(TruthMotion, uncovered_background_is_static_again_at_once) {
  EXPECT_EQ(motions({2000, 1990, 3000, 3000}), (std::vector{kStatic, kMoving, kMoving, kStatic}));
}

}  // namespace
}  // namespace roomcast::bench
