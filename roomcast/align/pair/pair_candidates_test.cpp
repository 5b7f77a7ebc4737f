// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/pair_candidates.h"

#include <gtest/gtest.h>

#include "roomcast/align/made_up_views.h"
#include "roomcast/align/pair/pose_difference.h"

namespace roomcast::align {
namespace {

const RigidTransform& truth() {
  static const RigidTransform pose = true_pose(first_corner(), second_corner());
  return pose;
}

PairCandidates candidates_of(const MadeUpView& a, const MadeUpView& b) {
  const ViewComparison comparison = compare_views(*a.view, *b.view);
  return {*a.view, *b.view,
          weighed_matches(*a.view, own_look_alikes(*a.view), *b.view, own_look_alikes(*b.view),
                          comparison)};
}

const PairCandidates& corners() {
  static const PairCandidates candidates = candidates_of(first_corner(), second_corner());
  return candidates;
}

RigidTransform shifted(RigidTransform pose, const Eigen::Vector3d& by_m) {
  pose.translation_m += by_m;
  return pose;
}

TEST(PairCandidates, the_truth_comes_first_and_is_strong) {
  const auto& ranked = corners().ranked();
  ASSERT_FALSE(ranked.empty());
  EXPECT_LT(difference(ranked[0].a_from_b, truth()).angle_rad, 0.01);
  EXPECT_LT(difference(ranked[0].a_from_b, truth()).distance_m, 0.03);
  EXPECT_TRUE(is_strong(ranked[0]));
  EXPECT_GT(corners().margin(), kLeastMargin);
}

TEST(PairCandidates, are_ranked_and_different) {
  const auto& ranked = corners().ranked();
  for (std::size_t i = 1; i < ranked.size(); ++i) {
    EXPECT_LE(ranked[i].score, ranked[i - 1].score);
    EXPECT_TRUE(are_rivals(ranked[i].a_from_b, ranked[i - 1].a_from_b));
  }
}

TEST(PairCandidates, are_never_strong_without_matches) {
  const PairCandidates by_shape(*first_corner().view, *second_corner().view, {});
  for (const PoseEvidence& evidence : by_shape.ranked()) EXPECT_FALSE(is_strong(evidence));
}

TEST(FreeSpace, truth_has_no_conflict) {
  const auto check =
      check_free_space(first_corner().view->surface, second_corner().view->surface, truth(), 4000);
  EXPECT_GT(check.consistent, 0.15);
  EXPECT_LT(check.conflict(), 0.01);
  EXPECT_LE(check.consistent_least, check.consistent + 1e-9);
}

TEST(FreeSpace, a_sensor_inside_a_wall_violates) {
  const auto check = check_free_space(first_corner().view->surface, second_corner().view->surface,
                                      shifted(truth(), {0, 0, -1.2}), 4000);
  EXPECT_GT(check.conflict(), 0.2);
}

TEST(FreeSpace, views_that_do_not_meet_say_nothing) {
  RigidTransform away = truth();
  away.translation_m.y() += 100;
  const auto check =
      check_free_space(first_corner().view->surface, second_corner().view->surface, away, 4000);
  EXPECT_EQ(check.consistent, 0);
  EXPECT_EQ(check.violating, 0);
}

TEST(PhotoConsistency, colours_agree_at_the_truth_and_not_beside_it) {
  const auto right = check_photo_consistency(*first_corner().view, *second_corner().view, truth());
  EXPECT_GT(right.correlation, 0.6);
  EXPECT_GT(right.textured, 0.05);
  const auto wrong = check_photo_consistency(*first_corner().view, *second_corner().view,
                                             shifted(truth(), {0.25, 0, 0.1}));
  EXPECT_LT(wrong.correlation, 0.3);
}

TEST(PhotoConsistency, does_not_mind_another_exposure) {
  CalibrationBundle dark = made_up_bundle({}, "dark", second_corner().world_from_depth);
  for (int y = 0; y < dark.color.height(); ++y) {
    for (int x = 0; x < dark.color.width(); ++x) {
      auto& pixel = dark.color.at(x, y);
      pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(20 + pixel.g / 2);
    }
  }
  const auto view = make_sensor_view(dark);
  ASSERT_TRUE(view.ok());
  EXPECT_GT(check_photo_consistency(*first_corner().view, *view, truth()).correlation, 0.6);
}

TEST(FeatureMatches, weigh_less_where_the_pattern_repeats) {
  MadeUpRoom tiled;
  tiled.period_m = 0.8;
  const auto a = made_up_view(tiled, "s0", corner_pose(2, 1.5));
  const auto b = made_up_view(tiled, "s1", corner_pose(-2, 1.5));
  const auto mean_weight = [](const std::vector<PointMatch>& matches) {
    double sum = 0;
    for (const PointMatch& match : matches) sum += double(match.weight);
    return sum / double(std::max<std::size_t>(1, matches.size()));
  };
  EXPECT_LT(mean_weight(candidates_of(a, b).matches()), 0.8 * mean_weight(corners().matches()));
}

}  // namespace
}  // namespace roomcast::align
