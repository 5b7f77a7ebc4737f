// SPDX-License-Identifier: Apache-2.0
// Sensors side by side in front of a printed wall, with exact matches.
#include "roomcast/alignment/rig/rig_refinement.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kRefinedError_m = 0.0005;  // matches and surfaces are exact to single precision

/// Two sensors 0.6 m apart.
struct RefinedPair {
  SensorView a = wall_view({}, 0, "a"), b = wall_view({}, 0.6, "b");
  RigidTransform truth = wall_pose(0, 0.6);
  PairCandidates candidates{a, b, wall_matches(a, b, truth)};
  std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
};

RigidTransform off_by_two_centimetres(const RigidTransform& pose) {
  Vector6 step;
  step << 0.008, -0.006, 0.01, 0.015, -0.01, 0.01;
  return step_transform(step) * pose;
}

TEST(RigRefinement, finds_the_exact_pose_from_two_centimetres_away) {
  const RefinedPair two;
  const std::vector<RigidTransform> start = {{}, off_by_two_centimetres(two.truth)};
  ASSERT_GT(difference(start[1], two.truth).distance_m, 0.02);
  const auto refined = refine_rig(start, 0, two.pairs);
  EXPECT_LT(difference(refined[1].origin_from_sensor, two.truth).distance_m, kRefinedError_m);
  EXPECT_LT(refined[1].correction.color_shift_px.norm(), 0.1);
}

TEST(RigRefinement, surfaces_alone_hold_the_distance_to_the_wall) {
  const SensorView a = wall_view({}, 0, "a"), b = wall_view({}, 0.6, "b");
  const PairCandidates no_matches(a, b, {});
  const std::array<RigPair, 1> pairs = {{{0, 1, &no_matches}}};
  RigidTransform off = wall_pose(0, 0.6);
  off.translation_m.z() += 0.03;
  const auto refined = refine_rig(std::vector<RigidTransform>{{}, off}, 0, pairs);
  EXPECT_NEAR(refined[1].origin_from_sensor.translation_m.z(), 0, kRefinedError_m);
  EXPECT_NEAR(refined[1].origin_from_sensor.translation_m.x(), 0.6, kRefinedError_m);
}

TEST(RigRefinement, the_origin_stays_whichever_it_is) {
  const RefinedPair two;
  const RigidTransform elsewhere = off_by_two_centimetres(wall_pose(3, 0));
  const std::vector<RigidTransform> start = {off_by_two_centimetres(elsewhere),
                                             elsewhere * two.truth};
  const auto refined = refine_rig(start, 1, two.pairs);
  EXPECT_LT(difference(refined[1].origin_from_sensor, start[1]).distance_m, 1e-9);
  EXPECT_LT(difference(refined[0].origin_from_sensor, elsewhere).distance_m, kRefinedError_m);
}

TEST(RigRefinement, sensors_in_no_pair_do_not_move) {
  const RefinedPair two;
  const RigidTransform third = off_by_two_centimetres({});
  const std::vector<RigidTransform> start = {{}, two.truth, third};
  const auto refined = refine_rig(start, 0, two.pairs);
  EXPECT_EQ(refined[2].origin_from_sensor.rotation, third.rotation);
  EXPECT_EQ(refined[2].origin_from_sensor.translation_m, third.translation_m);
  EXPECT_TRUE(refined[2].covariance.isZero());
}

TEST(RigRefinement, tells_how_exactly_each_pose_is_known) {
  const RefinedPair two;
  const std::vector<RigidTransform> start = {{}, two.truth};
  const auto refined = refine_rig(start, 0, two.pairs);
  EXPECT_EQ(refined[0].covariance, Matrix6::Zero());
  for (Eigen::Index i = 0; i < 6; ++i) EXPECT_GT(refined[1].covariance(i, i), 0) << i;
  // Depth may be off by 1 mm of either sensor: the wall does not say whose. Features fix the rest.
  const double forward_m = std::sqrt(refined[1].covariance(5, 5));
  EXPECT_GT(forward_m, 0.001);
  EXPECT_LT(forward_m, 0.01);
}

TEST(RigRefinement, without_pairs_gives_back_what_it_got) {
  const std::vector<RigidTransform> start = {{}, wall_pose(0, 0.6)};
  const auto refined = refine_rig(start, 0, {});
  ASSERT_EQ(refined.size(), 2u);
  EXPECT_EQ(refined[1].origin_from_sensor.translation_m, start[1].translation_m);
  EXPECT_TRUE(refined[1].covariance.isZero());
}

}  // namespace
}  // namespace roomcast::alignment
