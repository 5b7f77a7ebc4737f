// SPDX-License-Identifier: Apache-2.0
// A room through which a box walks, seen by two sensors with exact readings, one of them in need of
// a factor.
#include "roomcast/alignment/rig/depth_scales.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kExactPose = corner_pose(2, 1.5), kScaledPose = corner_pose(2, -1.5);

std::vector<DepthScale> scales_of(const SensorView& a, const SensorView& b,
                                  double uncalibrated_belief) {
  const PairCandidates candidates(a, b, {});
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
  std::vector<RefinedSensor> start = {{{}, {}}, {kExactPose.inverse() * kScaledPose, {}}};
  for (RefinedSensor& sensor : start) sensor.uncalibrated_belief = uncalibrated_belief;
  return estimate_depth_scales(start, 0, pairs);
}

TEST(DepthScales, a_sensor_that_reads_too_near_gets_its_factor) {
  const auto a = walk_view({}, "a", kExactPose);
  const auto b = walk_view({}, "b", kScaledPose, 1.04);
  const auto scales = scales_of(*a, *b, 1);
  EXPECT_EQ(scales[0].standard_error, 0);
  const double ratio = scales[1].factor / scales[0].factor;
  EXPECT_NEAR(ratio, 1.04, 0.02);
  EXPECT_GT(scales[1].standard_error, 0);
  EXPECT_LT(std::abs(ratio - 1.04), 2 * scales[1].standard_error);
  EXPECT_NEAR(scales[0].factor * scales[1].factor, 1, 1e-9) << "neither knows the true scale";
}

TEST(DepthScales, an_exact_sensor_keeps_its_readings) {
  const auto a = walk_view({}, "a", kExactPose), b = walk_view({}, "b", kScaledPose);
  EXPECT_EQ(scales_of(*a, *b, 0)[1].factor, 1);
}

TEST(DepthScales, are_not_determined_where_nothing_moves) {
  const auto a = walk_view({}, "a", kExactPose);
  SensorView still = *walk_view({}, "b", kScaledPose, 1.04);
  still.instants.clear();
  const auto scales = scales_of(*a, still, 1);
  EXPECT_EQ(scales[1].factor, 1);
  EXPECT_EQ(scales[1].standard_error, 0);
}

TEST(DepthScales, uncalibrated_sensors_are_refined_with_larger_errors) {
  const auto a = walk_view({}, "a", kExactPose), b = walk_view({}, "b", kScaledPose);
  const PairCandidates candidates(*a, *b, {});
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
  const RigidTransform truth = kExactPose.inverse() * kScaledPose;
  std::vector<RefinedSensor> sensors = {{{}, {}}, {truth, {}}};
  sensors[1].covariance = 1e-6 * Matrix6::Identity();
  for (RefinedSensor& sensor : sensors) sensor.uncalibrated_belief = 1;
  refine_uncalibrated(0, pairs, {}, {}, {}, sensors);
  EXPECT_LT((sensors[1].origin_from_sensor.translation_m - truth.translation_m).norm(), 0.06);
  EXPECT_GT(sensors[1].covariance.trace(), 1e-5);
  EXPECT_TRUE(sensors[0].covariance.isZero());
}

}  // namespace
}  // namespace roomcast::alignment
