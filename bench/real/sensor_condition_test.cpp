// SPDX-License-Identifier: Apache-2.0
#include "bench/real/sensor_condition.h"

#include <gtest/gtest.h>

#include "roomcast/sensor/disturbed_wall_fixture.h"

namespace roomcast::bench {
namespace {

SensorCondition condition(const sensor::DisturbedWall& wall, unsigned frames) {
  std::vector<DepthImage> all;
  for (unsigned i = 0; i < frames; ++i) all.push_back(wall.frame(i));
  return condition_of("s0", all);
}

TEST(SensorConditionTest, the_noise_of_a_still_wall_is_learnt_where_it_stands) {
  const SensorCondition still = condition({.noise_mm = 6}, 36);
  ASSERT_FALSE(still.noise.empty());
  for (const NoiseAtDistance& noise : still.noise) {
    EXPECT_GT(noise.sigma_mm, 5) << noise.distance_m;
    EXPECT_LT(noise.sigma_mm, 10) << noise.distance_m;
    EXPECT_GT(noise.distance_m, 1);
    EXPECT_LT(noise.distance_m, 3);
  }
}

TEST(SensorConditionTest, interference_is_measured_and_filtered) {
  const SensorCondition quiet = condition({}, 36), disturbed = condition({.lost = 0.05}, 36);
  EXPECT_LT(quiet.interference.flickering, 0.001);
  EXPECT_EQ(quiet.held, 0);
  EXPECT_GT(disturbed.interference.flickering, 0.02);
  EXPECT_LT(disturbed.filtered.flickering, 0.01);
  EXPECT_NEAR(disturbed.held, 0.05, 0.015);
}

TEST(SensorConditionTest, a_recording_of_few_frames_is_played_again) {
  EXPECT_TRUE(condition({.lost = 0.05}, 3).interference.is_known);
  EXPECT_EQ(condition({}, 1).interference.flickering, 0);
}

}  // namespace
}  // namespace roomcast::bench
