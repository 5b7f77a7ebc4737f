// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/placement_solver.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/service/board_fixture.h"
#include "roomcast/alignment/service/known_room_fixture.h"
#include "roomcast/alignment/service/walk_fixture.h"

namespace roomcast::alignment {
namespace {

TEST(PlacementSolver, a_view_of_no_use_is_reported) {
  auto dark = alignment::bundle_fixture({}, "dark", alignment::corner_pose(2, 1.5));
  dark.color = ColorImage(dark.color.width(), dark.color.height());
  PlacementSolver placing;
  placing.add(dark);
  const auto placements = placing.solve({});
  ASSERT_EQ(placements.size(), 1U);
  EXPECT_EQ(placements[0].sensor, "dark");
  EXPECT_FALSE(placements[0].pose.note.empty());
}

/// A long grey corridor, lit from one side: the views do not determine the position along it.
alignment::CalibrationBundle in_corridor(const std::string& name,
                                         const RigidTransform& world_from_depth) {
  alignment::RoomFixture corridor;
  corridor.walls = {Eigen::Vector3d(-30, 0, -2), Eigen::Vector3d(30, 2.6, 1.8)};
  corridor.boxes.clear();
  return alignment::without_pattern(alignment::bundle_fixture(corridor, name, world_from_depth));
}

TEST(PlacementSolver, a_walk_tells_where_a_sensor_stands_and_what_both_see_how_exactly) {
  const RigidTransform first = world_from_optical_looking_at({-1, 1.7, -1.6}, {-0.3, 0.6, 1});
  const RigidTransform second = world_from_optical_looking_at({1, 1.7, -1.6}, {0.3, 0.6, 1});
  PlacementSolver placing;
  placing.add(in_corridor("first", first));
  placing.add(in_corridor("second", second));
  const auto placed_second = [&] {
    const auto placements = placing.solve(given_room({{"first", first}}));
    return *std::ranges::find(placements, "second", &Placement::sensor);
  };
  ASSERT_FALSE(placed_second().pose.is_placed()) << "it could be anywhere along the corridor";
  ASSERT_TRUE(placing.wants_sightings());

  // The two sensors see the crown at different depths: this shifts the walk by half of the
  // difference.
  placing.see("first", stroll_seen_from(first, 0.11));
  placing.see("second", stroll_seen_from(second, 0.03));
  const Placement found = placed_second();
  ASSERT_TRUE(found.pose.is_placed()) << found.pose.note;
  const Eigen::Vector3d off = found.pose.world_from_depth.translation_m - second.translation_m;
  EXPECT_NEAR(off.z(), 0, 0.01) << "the wall tells";
  EXPECT_NEAR(off.x(), 0, 0.06) << "the walk tells";
}

Placement of(const std::string& sensor, const std::vector<Placement>& placements) {
  const auto found = std::ranges::find(placements, sensor, &Placement::sensor);
  return found == placements.end() ? Placement{} : *found;
}

double apart_m(const RigidTransform& one, const RigidTransform& other) {
  return alignment::difference(one, other).distance_m;
}

bool same_bits(const Placement& one, const RigidTransform& other) {
  return one.pose.is_placed() &&
         row_major_from_transform(one.pose.world_from_depth) == row_major_from_transform(other);
}

const RigidTransform kLeftCorner = alignment::corner_pose(2, 1.5),
                     kRightCorner = alignment::corner_pose(-2, 1.5);
const RigidTransform kThird = alignment::corner_pose(-2, -1.5);
const RigidTransform kFirst = world_from_optical_looking_at({-1, 1.7, -1.6}, {-0.3, 0.6, 1});
const RigidTransform kSecond = world_from_optical_looking_at({1, 1.7, -1.6}, {0.3, 0.6, 1});

TEST(PlacementSolver, who_is_placed_keeps_its_pose_bit_for_bit_when_another_joins) {
  PlacementSolver placing;
  placing.add(alignment::bundle_fixture({}, "left", kLeftCorner));
  placing.add(alignment::bundle_fixture({}, "right", kRightCorner));
  const auto two = placing.solve({});
  ASSERT_TRUE(of("left", two).pose.is_placed() && of("right", two).pose.is_placed());
  KnownRoom room;
  for (const Placement& placement : two) room[placement.sensor].pose = placement.pose;
  placing.add(alignment::bundle_fixture({}, "third", kThird));
  const auto three = placing.solve(room);
  EXPECT_TRUE(of("third", three).pose.is_placed());
  EXPECT_TRUE(same_bits(of("left", three), room.at("left").pose.world_from_depth));
  EXPECT_TRUE(same_bits(of("right", three), room.at("right").pose.world_from_depth));
}

TEST(PlacementSolver, a_room_whose_poses_are_stored_is_verified_and_stays_where_it_was) {
  const KnownPoses before = {{"left", kLeftCorner}, {"right", kRightCorner}};
  PlacementSolver placing;
  placing.add(alignment::bundle_fixture({}, "left", kLeftCorner));
  const auto alone = placing.solve(stored_room(before));
  EXPECT_FALSE(of("left", alone).pose.is_placed()) << "nothing to compare it with yet";
  EXPECT_FALSE(of("left", alone).withdrawn);
  placing.add(alignment::bundle_fixture({}, "right", kRightCorner));
  const auto both = placing.solve(stored_room(before));
  EXPECT_TRUE(same_bits(of("left", both), kLeftCorner));
  EXPECT_TRUE(same_bits(of("right", both), kRightCorner));
  EXPECT_FALSE(placing.wants_sightings());
}

TEST(PlacementSolver, who_was_moved_while_it_was_away_is_placed_where_it_stands_now) {
  PlacementSolver placing;
  placing.add(alignment::bundle_fixture({}, "left", kLeftCorner));
  placing.add(alignment::bundle_fixture({}, "right", kRightCorner));
  const KnownRoom room = given_room({{"left", kLeftCorner}}, {{"right", kThird}});
  const auto right = of("right", placing.solve(room));
  ASSERT_TRUE(right.pose.is_placed());
  EXPECT_LT(apart_m(right.pose.world_from_depth, kRightCorner), 0.02);
}

TEST(PlacementSolver, who_was_moved_and_cannot_be_placed_anew_is_withdrawn) {
  const auto turned_away = world_from_optical_looking_at({1, 1.7, -1.6}, {2.5, 0.9, -0.4});
  PlacementSolver placing;
  placing.add(in_corridor("first", kFirst));
  placing.add(in_corridor("second", turned_away));
  const KnownRoom room = given_room({{"first", kFirst}}, {{"second", kSecond}});
  const auto second = of("second", placing.solve(room));
  EXPECT_FALSE(second.pose.is_placed());
  EXPECT_TRUE(second.withdrawn);
  EXPECT_NE(second.pose.note.find("moved"), std::string::npos) << second.pose.note;
  EXPECT_TRUE(placing.wants_sightings());
}

class Corridor : public testing::Test {
 protected:
  Corridor() {
    placing.add(in_corridor("first", kFirst));
    placing.add(in_corridor("second", kSecond));
  }
  void walk() {
    placing.see("first", stroll_seen_from(kFirst, 0.11));
    placing.see("second", stroll_seen_from(kSecond, 0.03));
  }
  void hold_board() {
    placing.see("first", held_tag(kFirst));
    placing.see("second", held_tag(kSecond));
  }

  PlacementSolver placing;
  const RigidTransform truth = kFirst.inverse() * kSecond;
};

TEST_F(Corridor, where_nothing_tells_a_stored_pose_stays_and_a_walk_is_asked_for) {
  const KnownRoom room = given_room({{"first", kFirst}}, {{"second", kSecond}});
  const auto undecided = of("second", placing.solve(room));
  EXPECT_FALSE(undecided.pose.is_placed()) << "it could be anywhere along the corridor";
  EXPECT_FALSE(undecided.withdrawn);
  EXPECT_TRUE(placing.wants_sightings());
  walk();
  const auto walked = of("second", placing.solve(room));
  EXPECT_TRUE(same_bits(walked, kSecond)) << walked.pose.note;
  EXPECT_FALSE(placing.wants_sightings());
}

TEST_F(Corridor, a_walk_replaces_a_stored_pose_that_does_not_hold) {
  const KnownRoom room =
      given_room({{"first", kFirst}}, {{"second", alignment::beside(kSecond, {1, 0, 0}, 0)}});
  walk();
  const auto walked = of("second", placing.solve(room));
  ASSERT_TRUE(walked.pose.is_placed()) << walked.pose.note;
  EXPECT_LT(apart_m(walked.pose.world_from_depth, kSecond), 0.1);
}

TEST_F(Corridor, two_with_stored_poses_only_are_verified_together_by_a_board) {
  const KnownRoom room = stored_room({{"first", kFirst}, {"second", kSecond}});
  for (const Placement& placement : placing.solve(room)) {
    EXPECT_FALSE(placement.pose.is_placed());
    EXPECT_FALSE(placement.withdrawn);
  }
  hold_board();
  const auto placements = placing.solve(room);
  EXPECT_TRUE(same_bits(of("first", placements), kFirst));
  EXPECT_TRUE(same_bits(of("second", placements), kSecond));
}

TEST_F(Corridor, a_stored_pose_is_no_base_for_others_while_somebody_is_known) {
  KnownRoom room = given_room({{"elsewhere", kThird}}, {{"first", kFirst}});
  hold_board();
  EXPECT_FALSE(of("second", placing.solve(room)).pose.is_placed());
  room.erase("elsewhere");
  EXPECT_TRUE(of("second", placing.solve(room)).pose.is_placed());
}

TEST_F(Corridor, a_board_places_two_that_share_nothing_and_came_together) {
  ASSERT_FALSE(of("first", placing.solve({})).pose.is_placed());
  hold_board();
  const auto placements = placing.solve({});
  const auto first = of("first", placements), second = of("second", placements);
  ASSERT_TRUE(first.pose.is_placed() && second.pose.is_placed()) << second.pose.note;
  EXPECT_LT(apart_m(first.pose.world_from_depth.inverse() * second.pose.world_from_depth, truth),
            0.01);
  EXPECT_NEAR(first.pose.world_from_depth.translation_m.y(), 1.7, 0.02) << "over its floor";
  EXPECT_FALSE(placing.wants_sightings());
}

TEST_F(Corridor, whom_a_board_has_placed_a_walk_places_others_beside) {
  const auto third = world_from_optical_looking_at({3, 1.7, -1.6}, {0.6, 0.6, 1});
  placing.add(in_corridor("third", third));
  hold_board();
  placing.see("second", stroll_seen_from(kSecond, 0.03));
  placing.see("third", stroll_seen_from(third, 0.03));
  const auto placements = placing.solve(given_room({{"first", kFirst}}));
  ASSERT_TRUE(of("third", placements).pose.is_placed()) << of("third", placements).pose.note;
  EXPECT_LT(apart_m(of("third", placements).pose.world_from_depth, third), 0.15);
}

TEST(PlacementSolver, a_guess_beside_one_that_nobody_could_place_makes_the_world) {
  alignment::RoomFixture symmetric = alignment::nearly_symmetric_room();
  symmetric.boxes.pop_back();
  const auto one_pose = alignment::corner_pose(2, -1.5),
             other_pose = alignment::corner_pose(-2, 1.5);
  const RigidTransform truth = one_pose.inverse() * other_pose;
  PlacementSolver placing;
  placing.add(alignment::bundle_fixture(symmetric, "one", one_pose));
  placing.add(alignment::bundle_fixture(symmetric, "other", other_pose));
  const RigidTransform shown = alignment::beside(one_pose, {9, 0.3, 4}, 1);
  const KnownRoom room = room_of(PoseSource::kNone, {{"one", shown}});
  for (const Placement& placement : placing.solve(room))
    ASSERT_FALSE(placement.pose.is_placed()) << "turned by half the room looks alike";
  placing.nudge("other", alignment::beside(shown * truth, {0.05, 0, -0.04}, 0.02));
  const auto placements = placing.solve(room);
  const auto one = of("one", placements), other = of("other", placements);
  ASSERT_TRUE(one.pose.is_placed() && other.pose.is_placed()) << other.pose.note;
  EXPECT_LT(apart_m(one.pose.world_from_depth.inverse() * other.pose.world_from_depth, truth),
            0.03);
  EXPECT_NEAR(one.pose.world_from_depth.translation_m.y(), 1.9, 0.02) << "over its floor";
}

}  // namespace
}  // namespace roomcast::alignment
