// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/rigid_fit.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kTruePose = world_from_optical_looking_at({0.4, 1.2, -0.3}, {-1, 0.2, 0.8});

std::vector<PointMatch> exact_matches() {
  std::vector<PointMatch> matches;
  for (const Eigen::Vector3d& b :
       {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, 0, 2.5), Eigen::Vector3d(0, 1, 3),
        Eigen::Vector3d(-1, -0.5, 1.5), Eigen::Vector3d(0.5, 0.7, 2.2)}) {
    matches.push_back({(kTruePose * b).cast<float>(), b.cast<float>(), {0, 0}, {0, 0}});
  }
  return matches;
}

TEST(RigidFit, finds_the_motion_of_exact_matches) {
  const std::vector<float> weights(5, 1);
  const auto fitted = fit_a_from_b(exact_matches(), weights);
  ASSERT_TRUE(fitted.has_value());
  EXPECT_LT(difference(*fitted, kTruePose).angle_rad, 1e-5);
  EXPECT_LT(difference(*fitted, kTruePose).distance_m, 1e-5);
  EXPECT_NEAR(fitted->rotation.determinant(), 1, 1e-9);
}

TEST(RigidFit, what_has_no_weight_does_not_count) {
  auto matches = exact_matches();
  matches[2].a_m += Eigen::Vector3f(5, 5, 5);
  const auto fitted = fit_a_from_b(matches, std::vector<float>{1, 1, 0, 1, 1});
  ASSERT_TRUE(fitted.has_value());
  EXPECT_LT(difference(*fitted, kTruePose).distance_m, 1e-5);
}

TEST(RigidFit, refuses_too_few_points_and_points_on_a_line) {
  auto matches = exact_matches();
  EXPECT_FALSE(fit_a_from_b(matches, std::vector<float>{1, 1, 0, 0, 0}).has_value());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    matches[i].b_m = matches[i].a_m = {float(i), 2 * float(i), 1};
  }
  EXPECT_FALSE(fit_a_from_b(matches, std::vector<float>(5, 1)).has_value());
}

TEST(PoseDifference, measures_angle_and_where_the_view_is) {
  RigidTransform turned;
  turned.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
  EXPECT_NEAR(difference(turned, {}).angle_rad, 0.1, 1e-9);
  EXPECT_NEAR(difference(turned, {}).distance_m, 2 * 2.5 * std::sin(0.05), 1e-9);
  EXPECT_TRUE(are_rivals(turned, {}));
  EXPECT_FALSE(are_rivals(turned, turned));
}

TEST(MatchSupport, many_matches_in_one_place_are_one_witness) {
  std::vector<PointMatch> matches(5, {{1, 1, 1}, {1.01F, 1.01F, 1.01F}, {0, 0}, {0, 0}, 0.5F});
  matches[3].weight = 0.9F;
  EXPECT_FLOAT_EQ(static_cast<float>(match_support(matches).weight), 0.9F);
  EXPECT_EQ(match_support(matches).cells, 1);
  matches[0].b_m.x() += 1;
  EXPECT_FLOAT_EQ(static_cast<float>(match_support(matches).weight), 1.4F);
  EXPECT_EQ(match_support({}).cells, 0);
}

TEST(MatchSupport, only_what_agrees_with_the_pose_counts) {
  auto matches = exact_matches();
  matches[1].a_m += Eigen::Vector3f(0.2F, 0, 0);
  EXPECT_EQ(agreeing_matches(matches, kTruePose, 0.05F).size(), 4u);
  EXPECT_EQ(agreeing_matches(matches, kTruePose, 0.5F).size(), 5u);
}

}  // namespace
}  // namespace roomcast::alignment
