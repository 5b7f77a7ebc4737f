// SPDX-License-Identifier: Apache-2.0
// Two sensors side by side in front of a wall, with exact matches or ones that are off by a known
// number of pixels.
#include "roomcast/alignment/pair/feature_residuals.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kFromEachOther_m = 0.6;
constexpr double kFocal_px = 290, kWallDistance_m = 2;

/// Both views of the wall and exact matches.
struct MatchedWall {
  SensorView a = wall_view({}, 0), b = wall_view({}, kFromEachOther_m);
  PairState truth{wall_pose(0, kFromEachOther_m), {}, {}};
  std::vector<PointMatch> matches = wall_matches(a, b, truth.a_from_b);

  /// Moves the features in a's picture.
  void move_in_a(float x_px) {
    for (PointMatch& match : matches) match.a_pixel.x() += x_px;
  }
  [[nodiscard]] PairEquations equations(const PairState& state, const FeatureTrust& trust) const {
    return feature_equations(a.picture, b.picture, state, matches, trust);
  }
  [[nodiscard]] double sigma_px() const {
    return feature_sigma_px(a.picture, b.picture, truth, matches);
  }
};

TEST(FeatureEquations, vanish_at_the_truth) {
  const MatchedWall wall;
  const PairEquations equations = wall.equations(wall.truth, {1});
  EXPECT_EQ(equations.terms, static_cast<int>(4 * wall.matches.size()));  // x and y, both ways
  // Pixels are exact to 1e-4: single precision at 400 pixels.
  const double largest = equations.information.diagonal().cwiseSqrt().maxCoeff();
  EXPECT_LT(equations.gradient.cwiseAbs().maxCoeff(), 1e-4 * largest * equations.terms);
}

TEST(FeatureEquations, know_a_shift_along_the_wall_by_the_focal_length) {
  const MatchedWall wall;
  // Each match says x twice, with 290 / 2 pixels per metre and a sigma of 1 pixel.
  const double per_match = 2 * (kFocal_px / kWallDistance_m) * (kFocal_px / kWallDistance_m);
  const double all = per_match * double(wall.matches.size());
  EXPECT_NEAR(wall.equations(wall.truth, {1}).information(3, 3), all, 1e-3 * all);
  // A sigma twice as large says a quarter; errors that are not independent say their share.
  EXPECT_NEAR(wall.equations(wall.truth, {2}).information(3, 3), all / 4, 1e-3 * all);
  EXPECT_NEAR(wall.equations(wall.truth, {1, 0.1}).information(3, 3), all / 10, 1e-3 * all);
}

TEST(FeatureEquations, find_the_pose_from_a_step_away) {
  const MatchedWall wall;
  Vector6 nudge;
  nudge << 0.01, -0.02, 0.01, 0.03, -0.02, 0.02;
  PairState state = wall.truth;
  state.a_from_b = step_transform(nudge) * state.a_from_b;
  for (int i = 0; i < 8; ++i)
    state.a_from_b = step_transform(solve_motion(wall.equations(state, {10}))) * state.a_from_b;
  EXPECT_LT((state.a_from_b.translation_m - wall.truth.a_from_b.translation_m).norm(), 1e-5);
  EXPECT_LT((state.a_from_b.rotation - wall.truth.a_from_b.rotation).norm(), 1e-5);
}

TEST(FeatureEquations, ignore_residuals_of_25_pixels_or_more) {
  MatchedWall wall;
  const auto both_ways = static_cast<int>(4 * wall.matches.size());
  wall.move_in_a(24.5F);
  EXPECT_EQ(wall.equations(wall.truth, {1}).terms, both_ways);
  wall.move_in_a(1);
  EXPECT_EQ(wall.equations(wall.truth, {1}).terms, both_ways / 2);  // the way into b is exact
}

TEST(FeatureEquations, ignore_what_lies_behind_the_other_camera) {
  const MatchedWall wall;
  // b is turned upside down and moved so that its points are 2 m behind a, where the formula of the
  // camera would project them exactly onto their features.
  PairState behind;
  behind.a_from_b.rotation = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  behind.a_from_b.translation_m = {-kFromEachOther_m, 0, -2 * kWallDistance_m};
  // Of a's points, which are 6 m ahead of b, few come near their features.
  EXPECT_LT(wall.equations(behind, {1}).terms, static_cast<int>(wall.matches.size()));
}

TEST(FeatureEquations, a_corrected_colour_shift_leaves_no_residual) {
  MatchedWall wall;
  wall.move_in_a(-6);
  PairState corrected = wall.truth;
  corrected.a.color_shift_px = {6, 0};  // true place = seen place + shift
  // a's lifted points are seen aside, too, so they are corrected before they go into b.
  for (PointMatch& match : wall.matches)
    match.a_m.x() -= static_cast<float>(6 / kFocal_px * kWallDistance_m);
  const PairEquations off = wall.equations(wall.truth, {10});
  const PairEquations right = wall.equations(corrected, {10});
  EXPECT_LT(right.gradient.head<6>().norm(), 1e-3 * off.gradient.head<6>().norm());
}

TEST(FeatureScores, sum_up_to_the_gradient) {
  MatchedWall wall;
  wall.move_in_a(2);
  PairScores scores;
  add_feature_scores(wall.a.picture, wall.b.picture, wall.truth, wall.matches, {2, 0.5}, scores);
  PairVector by_a = PairVector::Zero(), by_b = PairVector::Zero();
  for (const auto& [patch, of_patch] : scores.of_a) by_a += of_patch.score;
  for (const auto& [patch, of_patch] : scores.of_b) by_b += of_patch.score;
  const PairVector gradient = wall.equations(wall.truth, {2, 0.5}).gradient;
  EXPECT_GT(scores.of_a.size(), 4u);
  EXPECT_LT((by_a - gradient).norm(), 1e-9 * gradient.norm());
  EXPECT_LT((by_b - gradient).norm(), 1e-9 * gradient.norm());
}

TEST(FeatureScores, count_where_either_sensor_sees_the_feature) {
  MatchedWall wall;
  wall.matches.resize(1);
  PairScores scores;
  add_feature_scores(wall.a.picture, wall.b.picture, wall.truth, wall.matches, {1}, scores);
  const int in_a = patch_of(wall.matches[0].a_m.cast<double>());
  const int in_b = patch_of(wall.matches[0].b_m.cast<double>());
  ASSERT_NE(in_a, in_b);  // 0.6 m apart at 2 m; a patch is 0.7 m wide there
  EXPECT_EQ(scores.of_a.size(), 1u);
  EXPECT_EQ(scores.of_a.count(in_a), 1u);
  EXPECT_EQ(scores.of_b.size(), 1u);
  EXPECT_EQ(scores.of_b.count(in_b), 1u);
}

TEST(FeatureSigma, is_that_of_the_median_residual) {
  MatchedWall wall;
  wall.move_in_a(2);
  // Half of the residuals are 0 and half are 2 pixels: the upper median is 2. The median distance
  // of a two-dimensional normal distribution is 1.1774 sigmas.
  EXPECT_NEAR(wall.sigma_px(), 2 / 1.1774, 1e-3);
  for (PointMatch& match : wall.matches) match.b_pixel.y() += 3;
  EXPECT_NEAR(wall.sigma_px(), 3 / 1.1774, 1e-3);
}

TEST(FeatureSigma, stays_within_reason) {
  MatchedWall wall;
  EXPECT_DOUBLE_EQ(wall.sigma_px(), 0.6);
  wall.move_in_a(20);
  EXPECT_DOUBLE_EQ(wall.sigma_px(), 3);
  wall.matches.clear();
  EXPECT_DOUBLE_EQ(wall.sigma_px(), 3);
}

}  // namespace
}  // namespace roomcast::alignment
