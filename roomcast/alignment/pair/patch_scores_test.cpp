// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/patch_scores.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

PairVector score_of(double value) {
  return PairVector::Constant(value);
}

TEST(PatchScores, a_patch_is_a_direction) {
  const Eigen::Vector3d point_m(0.3, -0.2, 1);
  EXPECT_EQ(patch_of(point_m), patch_of(3 * point_m));
  // A patch is 0.35 wide in x / z and in y / z.
  EXPECT_EQ(patch_of({0.01, 0.01, 1}), patch_of({0.34, 0.34, 1}));
  EXPECT_NE(patch_of({0.34, 0.01, 1}), patch_of({0.36, 0.01, 1}));
  EXPECT_NE(patch_of({0.01, 0.34, 1}), patch_of({0.01, 0.36, 1}));
  EXPECT_NE(patch_of({0.01, 0.01, 1}), patch_of({-0.01, 0.01, 1}));
  EXPECT_NE(patch_of({0.36, 0.01, 1}), patch_of({0.01, 0.36, 1}));
}

TEST(PatchScores, directions_far_aside_share_the_outermost_patch_of_their_row) {
  EXPECT_EQ(patch_of({100, 0.1, 1}), patch_of({200, 0.1, 1}));
  EXPECT_NE(patch_of({100, 0.1, 1}), patch_of({-100, 0.1, 1}));
  EXPECT_NE(patch_of({100, 0.1, 1}), patch_of({-100, 0.4, 1}));
}

TEST(PatchScores, a_term_counts_once_for_either_sensor) {
  const Eigen::Vector3d left(-0.1, 0.1, 1), right(0.1, 0.1, 1);
  PairScores scores;
  scores.add(left, right, score_of(2));
  scores.add(left, left, score_of(3));
  ASSERT_EQ(scores.of_a.size(), 1u);
  EXPECT_EQ(scores.of_a.at(patch_of(left)).score, score_of(5));
  ASSERT_EQ(scores.of_b.size(), 2u);
  EXPECT_EQ(scores.of_b.at(patch_of(right)).score, score_of(2));
  EXPECT_EQ(scores.of_b.at(patch_of(left)).score, score_of(3));
  EXPECT_EQ(scores.of_a.at(patch_of(left)).weight, 0);  // no surface term
}

TEST(PatchScores, surface_terms_keep_their_weighted_residuals) {
  const Eigen::Vector3d left(-0.1, 0.1, 1), right(0.1, 0.1, 1);
  PairScores scores;
  scores.add_surface(left, right, score_of(1), 0.02, 5);
  scores.add_surface(left, right, score_of(1), -0.01, 2);
  for (const PatchScore& patch :
       {scores.of_a.at(patch_of(left)), scores.of_b.at(patch_of(right))}) {
    EXPECT_EQ(patch.score, score_of(2));
    EXPECT_DOUBLE_EQ(patch.weight, 7);
    EXPECT_DOUBLE_EQ(patch.residual, 5 * 0.02 - 2 * 0.01);
  }
}

}  // namespace
}  // namespace roomcast::alignment
