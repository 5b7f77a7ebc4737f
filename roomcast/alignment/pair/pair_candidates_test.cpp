// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pair_candidates.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform& truth() {
  static const RigidTransform pose = true_pose(first_corner(), second_corner());
  return pose;
}

PairCandidates candidates_of(const ViewFixture& a, const ViewFixture& b) {
  const ViewComparison comparison = compare_views(*a.view, *b.view);
  return {*a.view, *b.view,
          weighted_matches(*a.view, own_ambiguity(*a.view), *b.view, own_ambiguity(*b.view),
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
  EXPECT_GT(corners().margin(), kMinMargin);
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

TEST(PairCandidates, are_judged_anew_with_the_matches_of_a_closer_look) {
  PairCandidates candidates(*first_corner().view, *second_corner().view, {});
  ASSERT_FALSE(candidates.has_plausible());
  candidates.add_affine_matches(corners().matches());
  EXPECT_TRUE(candidates.has_plausible());
  EXPECT_TRUE(is_strong(candidates.ranked()[0]));
  EXPECT_LT(difference(candidates.ranked()[0].a_from_b, truth()).distance_m, 0.03);
  EXPECT_GT(candidates.margin(), kMinMargin);
}

PoseEvidence evidence_of(double score, double correlation) {
  PoseEvidence evidence;
  evidence.score = score;
  evidence.photo = {0.4, correlation};
  return evidence;
}

TEST(PairCandidates, of_nearly_the_same_poses_the_one_with_the_colours_is_better) {
  const PoseEvidence exact = evidence_of(68, 0.88), aside = evidence_of(69, 0.61);
  EXPECT_TRUE(fits_better(exact, aside));
  EXPECT_FALSE(fits_better(aside, exact));
  EXPECT_FALSE(fits_better(exact, exact));
}

TEST(PairCandidates, colours_make_no_refuted_pose_better) {
  EXPECT_FALSE(fits_better(evidence_of(-20, 0.9), evidence_of(10, 0.6)));
  EXPECT_FALSE(fits_better(evidence_of(-20, 0.9), evidence_of(-10, 0.3)));
}

PoseEvidence weak_evidence() {
  PoseEvidence evidence;
  evidence.matches = {1.3, 12};
  evidence.space.consistent = 0.4;
  evidence.photo = {0.05, 0.6};
  evidence.score = 18;
  return evidence;
}

TEST(PooledEvidence, is_strong_when_several_weak_pairs_agree) {
  PooledEvidence pooled;
  for (const bool enough : {false, false, true}) {
    EXPECT_FALSE(is_strong(weak_evidence()));
    pooled.add(weak_evidence());
    EXPECT_EQ(is_strong(pooled), enough);
  }
}

TEST(PooledEvidence, is_not_strong_when_one_of_them_is_refuted) {
  PooledEvidence pooled;
  for (int i = 0; i < 3; ++i) pooled.add(weak_evidence());
  PoseEvidence refuted;
  refuted.score = -40;
  pooled.add(refuted);
  EXPECT_FALSE(is_strong(pooled));
}

TEST(SolidConflict, is_none_at_the_truth_nor_near_it) {
  const DepthSurface &a = first_corner().view->surface, &b = second_corner().view->surface;
  EXPECT_EQ(check_solid_conflict(a, b, truth()).violating, 0u);
  EXPECT_GT(check_solid_conflict(a, b, truth()).consistent, 100u);
  EXPECT_LE(check_solid_conflict(a, b, shifted(truth(), {0.05, 0, 0})).violating, 1u);
}

TEST(SolidConflict, is_a_box_that_one_sensor_looks_through) {
  RigidTransform half_a_turn;
  half_a_turn.rotation = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const RigidTransform turned =
      one_side().world_from_depth.inverse() * half_a_turn * other_side().world_from_depth;
  const auto conflict =
      check_solid_conflict(one_side().view->surface, other_side().view->surface, turned);
  EXPECT_GT(conflict.violating, 20u);
  EXPECT_GT(conflict.consistent, 10 * conflict.violating);
}

TEST(FreeSpace, truth_has_no_conflict) {
  const auto check =
      check_free_space(first_corner().view->surface, second_corner().view->surface, truth(), 4000);
  EXPECT_GT(check.consistent, 0.15);
  EXPECT_LT(check.conflict(), 0.01);
  EXPECT_LE(check.min_consistent, check.consistent + 1e-9);
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

/// The state with colour as calibrated.
PairState at(const RigidTransform& a_from_b) {
  return {a_from_b, {}, {}};
}

TEST(PhotoConsistency, colours_agree_at_the_truth_and_not_beside_it) {
  const auto right =
      check_photo_consistency(*first_corner().view, *second_corner().view, at(truth()));
  EXPECT_GT(right.correlation, 0.6);
  EXPECT_GT(right.textured, 0.05);
  const auto wrong = check_photo_consistency(*first_corner().view, *second_corner().view,
                                             at(shifted(truth(), {0.25, 0, 0.1})));
  EXPECT_LT(wrong.correlation, 0.3);
}

TEST(PhotoConsistency, does_not_mind_another_exposure) {
  CalibrationBundle dark = bundle_fixture({}, "dark", second_corner().world_from_depth);
  for (int y = 0; y < dark.color.height(); ++y) {
    for (int x = 0; x < dark.color.width(); ++x) {
      auto& pixel = dark.color.at(x, y);
      pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(20 + pixel.g / 2);
    }
  }
  const auto view = make_sensor_view(dark);
  ASSERT_TRUE(view.ok());
  EXPECT_GT(check_photo_consistency(*first_corner().view, *view, at(truth())).correlation, 0.6);
}

RoomFixture with_other_prints() {
  RoomFixture elsewhere;
  elsewhere.looks = 7;
  return elsewhere;
}

TEST(PairCandidates, views_from_one_place_that_show_something_else_are_of_two_rooms) {
  const RigidTransform beside = corner_pose(1.9, 1.5);
  const ViewFixture twin = view_fixture({}, "twin", beside);
  const ViewFixture stranger = view_fixture(with_other_prints(), "stranger", beside);
  const RigidTransform near = first_corner().world_from_depth.inverse() * beside;
  const PoseEvidence of_twin = candidates_of(first_corner(), twin).examine(near);
  EXPECT_FALSE(of_twin.is_look_alike);
  EXPECT_TRUE(is_strong(of_twin));
  const PoseEvidence of_stranger = candidates_of(first_corner(), stranger).examine(near);
  EXPECT_GT(of_stranger.space.min_consistent, 0.6) << "the walls of both rooms agree";
  EXPECT_TRUE(of_stranger.is_look_alike);
  EXPECT_LT(of_stranger.score, 0);
}

TEST(PairCandidates, views_from_elsewhere_may_look_different) {
  const ViewFixture stranger =
      view_fixture(with_other_prints(), "stranger", second_corner().world_from_depth);
  EXPECT_FALSE(candidates_of(first_corner(), stranger).examine(truth()).is_look_alike);
}

/// The second corner with its colour picture shifted right by `right_px`.
CalibrationBundle bundle_with_color_aside(int right_px) {
  CalibrationBundle bundle = bundle_fixture({}, "aside", second_corner().world_from_depth);
  for (int y = 0; y < bundle.color.height(); ++y) {
    for (int x = bundle.color.width() - 1; x >= 0; --x)
      bundle.color.at(x, y) = bundle.color.at(std::max(0, x - right_px), y);
  }
  return bundle;
}

TEST(PhotoConsistency, colours_that_lie_aside_agree_once_they_are_corrected) {
  constexpr int kAside_px = 10;
  const CalibrationBundle bundle = bundle_with_color_aside(kAside_px);
  const auto view = make_sensor_view(bundle);
  ASSERT_TRUE(view.ok());
  const SensorView& a = *first_corner().view;
  PairState state = at(truth());
  const double as_given = check_photo_consistency(a, *view, state).correlation;
  const double in_picture = double(view->picture.grey.width()) / bundle.color.width();
  state.b.color_shift_px = {-kAside_px * in_picture, 0};
  EXPECT_GT(check_photo_consistency(a, *view, state).correlation, as_given + 0.1);
}

TEST(FeatureMatches, weigh_less_where_the_pattern_repeats) {
  RoomFixture tiled;
  tiled.period_m = 0.8;
  const auto a = view_fixture(tiled, "s0", corner_pose(2, 1.5));
  const auto b = view_fixture(tiled, "s1", corner_pose(-2, 1.5));
  const auto mean_weight = [](const std::vector<PointMatch>& matches) {
    double sum = 0;
    for (const PointMatch& match : matches) sum += double(match.weight);
    return sum / double(std::max<std::size_t>(1, matches.size()));
  };
  EXPECT_LT(mean_weight(candidates_of(a, b).matches()), 0.8 * mean_weight(corners().matches()));
}

}  // namespace
}  // namespace roomcast::alignment
