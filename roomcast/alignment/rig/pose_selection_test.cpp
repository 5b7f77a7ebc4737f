// SPDX-License-Identifier: Apache-2.0
// Sensors side by side in front of a printed wall. Their matches are given, so the evidence of
// every pose is known.
#include "roomcast/alignment/rig/pose_selection.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kBetweenSensors_m = 0.6;
constexpr double kSelected_m = 0.01;  // matches are exact; candidates are refined to millimetres
constexpr double kNoAnswerBefore = 99;

/// Views of a wall, each 0.6 m to the right of the one before.
std::vector<SensorView> row_of_views(std::size_t sensors, const PrintedWall& wall = {}) {
  std::vector<SensorView> views;
  for (std::size_t i = 0; i < sensors; ++i)
    views.push_back(wall_view(wall, kBetweenSensors_m * double(i), "s" + std::to_string(i)));
  return views;
}

RigidTransform row_pose(std::size_t a, std::size_t b) {
  return wall_pose(kBetweenSensors_m * double(a), kBetweenSensors_m * double(b));
}

/// A pair with matches for its true pose.
PairCandidates right_candidates(const std::vector<SensorView>& views, std::size_t a, std::size_t b,
                                float weight = 1) {
  return {views[a], views[b], wall_matches(views[a], views[b], row_pose(a, b), 2, weight)};
}

double away_m(const PoseSelection& selection, std::size_t a, std::size_t b) {
  return difference(selection.best.relative(a, b), row_pose(a, b)).distance_m;
}

TEST(PoseSelection, without_pairs_everyone_stays_apart) {
  const PoseSelection selection = select_poses(3, {});
  EXPECT_EQ(selection.best.group, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(selection.best.score, 0);
  EXPECT_EQ(selection.origin, 0u);
}

TEST(PoseSelection, places_a_pair_by_its_best_pose) {
  const auto views = row_of_views(2);
  const PairCandidates pair = right_candidates(views, 0, 1, 0.1F);
  const std::array<RigPair, 1> pairs = {{{0, 1, &pair}}};
  const PoseSelection selection = select_poses(2, pairs);
  EXPECT_TRUE(selection.best.together(0, 1));
  EXPECT_LT(away_m(selection, 0, 1), kSelected_m);
  // The only other answer leaves the second sensor out, for a score of zero.
  EXPECT_DOUBLE_EQ(selection.best.score, pair.ranked()[0].score - kPoseCost);
  EXPECT_DOUBLE_EQ(selection.margin_to_unplaced[1], selection.best.score);
  EXPECT_DOUBLE_EQ(selection.margin_to_unplaced[0], kNoAnswerBefore);
  EXPECT_DOUBLE_EQ(selection.margin_to_rival[1], kNoAnswerBefore);
}

TEST(PoseSelection, does_not_place_a_pair_without_strong_evidence) {
  const auto views = row_of_views(2);
  // Some hundred places whose matches are worth next to nothing: the pose fits in every other way.
  const PairCandidates pair = right_candidates(views, 0, 1, 0.01F);
  ASSERT_FALSE(pair.ranked().empty());
  ASSERT_GT(pair.ranked()[0].score, kPoseCost);
  ASSERT_FALSE(is_strong(pair.ranked()[0]));
  const std::array<RigPair, 1> pairs = {{{0, 1, &pair}}};
  EXPECT_FALSE(select_poses(2, pairs).best.together(0, 1));
}

TEST(PoseSelection, knows_how_much_better_it_is_than_a_rival) {
  // A print that repeats every metre, and matches for two poses a metre apart, of which one has
  // lighter ones.
  const auto views = row_of_views(2, {.period_m = 1});
  auto matches = wall_matches(views[0], views[1], row_pose(0, 1), 2, 0.1F);
  const auto of_rival = wall_matches(views[0], views[1], wall_pose(1, kBetweenSensors_m), 2, 0.05F);
  matches.insert(matches.end(), of_rival.begin(), of_rival.end());
  const PairCandidates pair(views[0], views[1], matches);
  ASSERT_GE(pair.ranked().size(), 2u);
  ASSERT_TRUE(is_strong(pair.ranked()[1]));
  ASSERT_GT(pair.margin(), 0);
  const std::array<RigPair, 1> pairs = {{{0, 1, &pair}}};
  const PoseSelection selection = select_poses(2, pairs);
  EXPECT_DOUBLE_EQ(selection.margin_to_rival[1], pair.margin());
  EXPECT_DOUBLE_EQ(selection.margin_to_unplaced[1], pair.ranked()[0].score - kPoseCost);
}

TEST(PoseSelection, places_sensors_through_one_another) {
  const auto views = row_of_views(3);
  const PairCandidates left = right_candidates(views, 0, 1), right = right_candidates(views, 1, 2);
  const std::array<RigPair, 2> pairs = {{{0, 1, &left}, {1, 2, &right}}};
  const PoseSelection selection = select_poses(3, pairs);
  EXPECT_EQ(selection.best.group, (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_LT(away_m(selection, 0, 2), 2 * kSelected_m);
  EXPECT_NEAR(selection.best.score,
              left.ranked()[0].score + right.ranked()[0].score - 2 * kPoseCost, 1e-9);
}

TEST(PoseSelection, places_two_sensors_through_a_third_whatever_their_order) {
  const auto views = row_of_views(3);
  const PairCandidates left = right_candidates(views, 0, 2), right = right_candidates(views, 1, 2);
  const std::array<RigPair, 2> pairs = {{{0, 2, &left}, {1, 2, &right}}};
  const PoseSelection selection = select_poses(3, pairs);
  EXPECT_EQ(selection.best.group, (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_LT(away_m(selection, 0, 1), 2 * kSelected_m);
  EXPECT_LT(away_m(selection, 0, 2), kSelected_m);
}

TEST(PoseSelection, a_pair_that_closes_a_loop_adds_its_evidence_but_no_cost) {
  const auto views = row_of_views(3);
  const PairCandidates left = right_candidates(views, 0, 1), right = right_candidates(views, 1, 2);
  const PairCandidates across = right_candidates(views, 0, 2);
  const std::array<RigPair, 3> pairs = {{{0, 1, &left}, {0, 2, &across}, {1, 2, &right}}};
  double evidence = 0;
  for (const RigPair& pair : pairs) evidence += pair.candidates->ranked()[0].score;
  EXPECT_NEAR(select_poses(3, pairs).best.score, evidence - 2 * kPoseCost, 1e-9);
}

TEST(PoseSelection, the_lowest_sensor_of_the_largest_group_is_the_origin) {
  const auto views = row_of_views(3);
  const PairCandidates right = right_candidates(views, 1, 2);
  const std::array<RigPair, 1> pairs = {{{1, 2, &right}}};
  const PoseSelection selection = select_poses(4, pairs);
  EXPECT_EQ(selection.best.group, (std::vector<std::size_t>{0, 1, 1, 3}));
  EXPECT_EQ(selection.origin, 1u);
  EXPECT_TRUE(selection.best.group_from_sensor[1].rotation.isIdentity());
  EXPECT_TRUE(selection.best.group_from_sensor[1].translation_m.isZero());
}

}  // namespace
}  // namespace roomcast::alignment
