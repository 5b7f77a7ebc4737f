// SPDX-License-Identifier: Apache-2.0
// Sensors side by side in front of a printed wall. A pose off towards the wall contradicts the
// surfaces, one off along the wall only the print.
#include "roomcast/alignment/rig/rig_check.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kSideBySide_m = 2;  // a quarter of each view is common, at 2 m
constexpr double kMargin = 50;

std::vector<SensorView> checked_views(const std::vector<std::uint32_t>& prints) {
  std::vector<SensorView> views;
  for (std::size_t i = 0; i < prints.size(); ++i)
    views.push_back(wall_view({.looks = prints[i]}, kSideBySide_m * double(i)));
  return views;
}

/// An answer that places every sensor at its true pose, with the first as the origin.
RigAnswer true_answer(std::size_t sensors) {
  RigAnswer answer;
  answer.placed.assign(sensors, true);
  answer.selection.margin_to_rival.assign(sensors, kMargin);
  answer.selection.margin_to_unplaced.assign(sensors, kMargin);
  for (std::size_t i = 0; i < sensors; ++i)
    answer.refined.push_back({wall_pose(0, kSideBySide_m * double(i)), {}});
  return answer;
}

void put_into_the_wall(RigAnswer& answer, std::size_t sensor) {
  answer.refined[sensor].origin_from_sensor.translation_m.z() += 0.5;
}

/// Candidates of neighbours, without matches: only the answer's poses are examined.
class NeighboursCheck {
 public:
  explicit NeighboursCheck(const std::vector<std::uint32_t>& prints)
      : views_(checked_views(prints)) {
    candidates_.reserve(views_.size());
    for (std::size_t i = 0; i + 1 < views_.size(); ++i) {
      candidates_.emplace_back(views_[i], views_[i + 1], std::vector<PointMatch>{});
      pairs_.push_back({i, i + 1, &candidates_.back()});
    }
  }
  std::optional<std::size_t> operator()(const RigAnswer& answer,
                                        RigCheck check = RigCheck()) const {
    return check.contradicted_sensor(pairs_, answer);
  }
  [[nodiscard]] std::span<const RigPair> pairs() const { return pairs_; }

 private:
  std::vector<SensorView> views_;
  std::vector<PairCandidates> candidates_;
  std::vector<RigPair> pairs_;
};

TEST(RigCheck, the_truth_contradicts_nobody) {
  EXPECT_FALSE(NeighboursCheck({1, 1, 1})(true_answer(3)).has_value());
}

TEST(RigCheck, a_sensor_whose_wall_stands_in_front_of_the_others_is_contradicted) {
  // Its neighbour is contradicted, too, but has another neighbour that agrees.
  RigAnswer answer = true_answer(3);
  put_into_the_wall(answer, 2);
  EXPECT_EQ(NeighboursCheck({1, 1, 1})(answer), 2u);
}

TEST(RigCheck, sensors_that_are_not_calibrated_may_be_in_each_others_way) {
  RigCheckOptions options;
  options.max_uncalibrated_conflict = 1;
  options.negligible_solid = 1e6;
  RigAnswer answer = true_answer(2);
  put_into_the_wall(answer, 1);
  EXPECT_TRUE(NeighboursCheck({1, 1})(answer, RigCheck(options)).has_value());
  for (RefinedSensor& sensor : answer.refined) sensor.uncalibrated_belief = 1;
  EXPECT_FALSE(NeighboursCheck({1, 1})(answer, RigCheck(options)).has_value());
}

/// One that is vouched for always, or never.
RigCheckOptions with_vouching(double pairs) {
  RigCheckOptions options;
  options.vouching_pairs = pairs;
  options.max_vouched_conflict = options.max_vouched_solid = 1;
  return options;
}

TEST(RigCheck, what_moves_vouches_for_sensors_that_are_not_calibrated) {
  RigAnswer answer = true_answer(2);
  put_into_the_wall(answer, 1);
  const auto contradicted = [&](double vouching_pairs, double uncalibrated_belief) {
    for (RefinedSensor& sensor : answer.refined) sensor.uncalibrated_belief = uncalibrated_belief;
    return NeighboursCheck({1, 1})(answer, RigCheck(with_vouching(vouching_pairs))).has_value();
  };
  EXPECT_FALSE(contradicted(0, 1));
  EXPECT_TRUE(contradicted(1, 1)) << "nothing moves";
  EXPECT_TRUE(contradicted(0, 0)) << "they are calibrated";
}

TEST(RigCheck, of_two_that_contradict_each_other_it_is_not_the_origin) {
  const NeighboursCheck check({1, 1});
  RigAnswer answer = true_answer(2);
  put_into_the_wall(answer, 1);
  answer.selection.origin = 0;
  EXPECT_EQ(check(answer), 1u);
  answer.selection.origin = 1;
  EXPECT_EQ(check(answer), 0u);
}

TEST(RigCheck, of_two_that_contradict_each_other_it_is_the_one_with_the_smaller_margin) {
  const NeighboursCheck check({1, 1});
  RigAnswer answer = true_answer(2);
  put_into_the_wall(answer, 1);
  answer.selection.origin = 2;  // neither
  answer.selection.margin_to_rival = {10, 20};
  EXPECT_EQ(check(answer), 0u);
  answer.selection.margin_to_unplaced = {40, 5};
  EXPECT_EQ(check(answer), 1u);
}

TEST(RigCheck, sensors_that_are_not_placed_are_not_checked) {
  RigAnswer answer = true_answer(2);
  put_into_the_wall(answer, 1);
  answer.placed[1] = false;
  EXPECT_FALSE(NeighboursCheck({1, 1})(answer).has_value());
}

TEST(RigCheck, a_pose_off_along_the_wall_is_contradicted_by_its_print) {
  const NeighboursCheck check({1, 1});
  RigAnswer aside = true_answer(2);
  aside.refined[1].origin_from_sensor.translation_m.x() += 0.3;
  // The colours could be misaligned with their depth...
  EXPECT_FALSE(check(aside).has_value());
  // ...until they have agreed in an earlier check.
  RigCheck colors_known;
  ASSERT_FALSE(colors_known.contradicted_sensor(check.pairs(), true_answer(2)).has_value());
  EXPECT_EQ(check(aside, colors_known), 1u);
}

TEST(RigCheck, a_sensor_of_another_room_is_told_by_its_print_once_three_others_agree) {
  EXPECT_EQ(NeighboursCheck({1, 1, 1, 2})(true_answer(4)), 3u);
  // Two that agree are no majority.
  EXPECT_FALSE(NeighboursCheck({1, 1, 2})(true_answer(3)).has_value());
}

}  // namespace
}  // namespace roomcast::alignment
