// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/match_support.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

PointMatch match_at(const Eigen::Vector3f& place_m, float weight) {
  return {place_m, place_m, {0, 0}, {0, 0}, weight};
}

TEST(MatchSupport, is_the_sum_over_places_of_the_best_match) {
  const std::vector<PointMatch> matches = {match_at({0.02F, 0.02F, 1.02F}, 0.25F),
                                           match_at({0.03F, 0.02F, 1.02F}, 0.75F),
                                           match_at({0.52F, 0.02F, 1.02F}, 0.5F)};
  EXPECT_DOUBLE_EQ(match_support(matches).weight, 0.75 + 0.5);
  EXPECT_EQ(match_support(matches).cells, 2);
}

TEST(MatchSupport, counts_places_of_5_cm_and_weighs_places_of_10_cm) {
  const std::vector<PointMatch> matches = {match_at({0.02F, 0.02F, 1.02F}, 1),
                                           match_at({0.07F, 0.02F, 1.02F}, 1)};
  EXPECT_DOUBLE_EQ(match_support(matches).weight, 1);
  EXPECT_EQ(match_support(matches).cells, 2);
}

TEST(MatchSupport, places_to_the_left_and_right_of_the_axis_are_two) {
  const std::vector<PointMatch> matches = {match_at({-0.01F, 0.02F, 1.02F}, 1),
                                           match_at({0.01F, 0.02F, 1.02F}, 1)};
  EXPECT_DOUBLE_EQ(match_support(matches).weight, 2);
  EXPECT_EQ(match_support(matches).cells, 2);
}

TEST(MatchSupport, every_direction_makes_another_place) {
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3f aside(0.02F, 0.02F, 1.02F);
    aside(axis) += 0.3F;
    EXPECT_EQ(
        match_support(std::vector{match_at({0.02F, 0.02F, 1.02F}, 1), match_at(aside, 1)}).cells,
        2);
  }
}

TEST(MatchSupport, of_no_matches_is_none) {
  EXPECT_EQ(match_support({}).weight, 0);
  EXPECT_EQ(match_support({}).cells, 0);
}

TEST(AgreeingMatches, are_those_that_the_pose_brings_together) {
  RigidTransform a_from_b;  // a quarter turn about z, and 1 m along x
  a_from_b.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  a_from_b.translation_m.x() = 1;
  // (0, 1, 2) in b is (0, 0, 2) in a.
  const PointMatch exact{{0, 0, 2}, {0, 1, 2}, {0, 0}, {0, 0}, 1};
  PointMatch near = exact, far = exact;
  near.a_m.z() += 0.04F;
  far.a_m.z() += 0.06F;
  const std::vector<PointMatch> all = {far, exact, near};
  const auto agreeing = agreeing_matches(all, a_from_b, 0.05F);
  ASSERT_EQ(agreeing.size(), 2u);
  EXPECT_EQ(agreeing[0].a_m, exact.a_m);  // in the order given
  EXPECT_EQ(agreeing[1].a_m, near.a_m);
  EXPECT_TRUE(agreeing_matches(all, a_from_b.inverse(), 0.05F).empty());
}

}  // namespace
}  // namespace roomcast::alignment
