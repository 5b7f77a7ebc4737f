// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/room_world.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/service/known_room_fixture.h"

namespace roomcast::alignment {
namespace {

RigidTransform pose_at_x(double x) {
  RigidTransform pose;
  pose.translation_m = {x, 1, 0};
  return pose;
}

alignment::AlignmentReport report_of(std::vector<alignment::SensorReport> sensors) {
  alignment::AlignmentReport report;
  report.sensors = std::move(sensors);
  return report;
}

alignment::SensorReport placed(const std::string& id, double x) {
  alignment::SensorReport sensor;
  sensor.id = id;
  sensor.placed = true;
  sensor.world_from_depth = pose_at_x(x);
  return sensor;
}

alignment::SensorReport lost(const std::string& id) {
  alignment::SensorReport sensor;
  sensor.id = id;
  sensor.reason = "turn it towards another";
  return sensor;
}

KnownRoom known(const KnownPoses& given, const KnownPoses& estimated) {
  KnownRoom room = given_room(given);
  add_poses(room, PoseSource::kEstimated, estimated);
  return room;
}

KnownRoom estimated(const KnownPoses& poses) {
  return known({}, poses);
}

double x_of(const Placement& placement) {
  return placement.pose.world_from_depth.translation_m.x();
}

TEST(RoomWorld, without_a_known_pose_the_world_is_the_reports) {
  const auto placements = RoomWorld().place(report_of({placed("a", 1), placed("b", 3)}), {});
  EXPECT_EQ(x_of(placements[0]), 1);
  EXPECT_EQ(x_of(placements[1]), 3);
}

TEST(RoomWorld, a_sensor_that_was_found_before_stays_and_the_others_come_to_it) {
  const auto placements = RoomWorld().place(report_of({placed("a", 1), placed("b", 3)}),
                                            estimated({{"b", pose_at_x(10)}}));
  EXPECT_EQ(x_of(placements[0]), 8);
  EXPECT_EQ(x_of(placements[1]), 10);
}

TEST(RoomWorld, a_given_pose_goes_before_one_that_was_found) {
  const auto placements = RoomWorld().place(report_of({placed("a", 1), placed("b", 3)}),
                                            known({{"b", pose_at_x(20)}}, {{"a", pose_at_x(1)}}));
  EXPECT_EQ(x_of(placements[0]), 18);
  EXPECT_EQ(x_of(placements[1]), 20);
}

TEST(RoomWorld, one_that_was_moved_unnoticed_does_not_take_the_room_along) {
  const KnownPoses before = {{"a", pose_at_x(1)}, {"b", pose_at_x(3)}, {"c", pose_at_x(5)}};
  const auto placements = RoomWorld().place(
      report_of({placed("a", 0), placed("b", 2.5), placed("c", 4.5)}), estimated(before));
  EXPECT_DOUBLE_EQ(x_of(placements[0]), 0.5);
  EXPECT_DOUBLE_EQ(x_of(placements[1]), 3);
  EXPECT_DOUBLE_EQ(x_of(placements[2]), 5);
}

/// A world with "a" in a provisional frame.
RoomWorld provisional_world() {
  RoomWorld world;
  EXPECT_EQ(x_of(world.place(report_of({placed("a", 1)}), {})[0]), 1);
  return world;
}

TEST(RoomWorld, a_provisional_one_stays_while_nobody_gives_another) {
  RoomWorld world = provisional_world();
  const auto placements =
      world.place(report_of({placed("a", 0), placed("b", 2)}), estimated({{"a", pose_at_x(1)}}));
  EXPECT_EQ(x_of(placements[0]), 1);
  EXPECT_EQ(x_of(placements[1]), 3);
}

TEST(RoomWorld, a_provisional_one_ends_when_somebody_gives_a_place_that_nothing_connects_with_it) {
  RoomWorld world = provisional_world();
  const KnownRoom room = known({{"b", pose_at_x(20)}}, {{"a", pose_at_x(1)}});
  const auto placements = world.place(report_of({lost("a"), lost("b")}), room);
  EXPECT_FALSE(placements[0].pose.is_placed());
  EXPECT_TRUE(placements[0].withdrawn);
  EXPECT_FALSE(placements[1].withdrawn);
  EXPECT_TRUE(world.estimated_in_world(room).empty());
}

TEST(RoomWorld, who_is_placed_without_those_whose_places_are_given_has_no_place) {
  RoomWorld world = provisional_world();
  const auto placements = world.place(report_of({placed("a", 1)}),
                                      known({{"b", pose_at_x(20)}}, {{"a", pose_at_x(1)}}));
  EXPECT_FALSE(placements[0].pose.is_placed());
  EXPECT_TRUE(placements[0].withdrawn);
  EXPECT_FALSE(placements[0].pose.note.empty());
}

TEST(RoomWorld, a_provisional_one_joins_the_given_one_where_something_connects_them) {
  RoomWorld world = provisional_world();
  const KnownPoses given = {{"b", pose_at_x(20)}};
  const auto placements =
      world.place(report_of({placed("a", 1), placed("b", 3)}), known(given, {{"a", pose_at_x(1)}}));
  EXPECT_EQ(x_of(placements[0]), 18);
  EXPECT_EQ(x_of(placements[1]), 20);
  const auto later = world.place(report_of({placed("a", 1)}), known(given, {{"a", pose_at_x(18)}}));
  EXPECT_EQ(x_of(later[0]), 18) << "it stands in the given world now";
}

alignment::SensorReport placed_within(const std::string& id, double x, double expected_error_mm) {
  auto sensor = placed(id, x);
  sensor.expected_error_mm = expected_error_mm;
  return sensor;
}

TEST(RoomWorld, a_pose_that_is_as_exact_as_expected_stays_bit_for_bit_when_another_joins) {
  const KnownPoses before = {{"a", pose_at_x(1)}, {"b", pose_at_x(3)}};
  const auto report =
      report_of({placed("a", 1), placed_within("b", 3.006, 4), placed_within("c", 5, 4)});
  const auto placements = RoomWorld().place(report, estimated(before));
  EXPECT_EQ(x_of(placements[0]), 1);
  EXPECT_EQ(x_of(placements[1]), 3);
  EXPECT_EQ(placements[1].pose.expected_error_mm, 4);
  EXPECT_EQ(x_of(placements[2]), 5);
}

TEST(RoomWorld, a_pose_that_was_wrong_is_corrected) {
  const KnownPoses before = {{"a", pose_at_x(1)}, {"b", pose_at_x(3)}};
  const auto placements = RoomWorld().place(
      report_of({placed("a", 1), placed_within("b", 3.03, 4)}), estimated(before));
  EXPECT_DOUBLE_EQ(x_of(placements[1]), 3.03);
}

TEST(RoomWorld, a_whole_room_with_stored_poses_stays_where_it_was) {
  const auto placements =
      RoomWorld().place(report_of({placed("a", 1), placed("b", 3)}),
                        stored_room({{"a", pose_at_x(11)}, {"b", pose_at_x(13)}}));
  EXPECT_EQ(x_of(placements[0]), 11);
  EXPECT_EQ(x_of(placements[1]), 13);
}

TEST(RoomWorld, one_with_a_stored_pose_alone_is_not_verified_by_itself) {
  const auto placements =
      RoomWorld().place(report_of({placed("a", 0)}), stored_room({{"a", pose_at_x(11)}}));
  EXPECT_FALSE(placements[0].pose.is_placed());
  EXPECT_FALSE(placements[0].withdrawn);
  EXPECT_FALSE(placements[0].pose.note.empty());
}

TEST(RoomWorld, beside_one_with_a_stored_pose_others_are_placed_where_nothing_better_is_here) {
  const auto report = report_of({placed("a", 1), placed("b", 3)});
  KnownRoom room = stored_room({{"a", pose_at_x(11)}});
  EXPECT_EQ(x_of(RoomWorld().place(report, room)[1]), 13);
  add_poses(room, PoseSource::kEstimated, {{"elsewhere", pose_at_x(0)}});
  const auto placements = RoomWorld().place(report, room);
  EXPECT_FALSE(placements[0].pose.is_placed());
  EXPECT_FALSE(placements[1].pose.is_placed());
  room["elsewhere"].is_connected = false;
  EXPECT_EQ(x_of(RoomWorld().place(report, room)[1]), 13);
}

TEST(RoomWorld, one_that_stood_alone_gives_way_to_others_who_stand_together) {
  RoomWorld world = provisional_world();
  const auto placements = world.place(report_of({lost("a"), placed("b", 2), placed("c", 3)}),
                                      estimated({{"a", pose_at_x(1)}}));
  EXPECT_TRUE(placements[0].withdrawn);
  EXPECT_EQ(x_of(placements[1]), 2);
}

TEST(RoomWorld, two_worlds_that_nothing_connects_are_not_laid_over_one_another) {
  const auto placements = RoomWorld().place(report_of({placed("a", 1), placed("b", 3), lost("c")}),
                                            estimated({{"c", pose_at_x(2)}}));
  EXPECT_FALSE(placements[0].pose.is_placed());
  EXPECT_FALSE(placements[1].pose.is_placed());
  EXPECT_FALSE(placements[0].pose.note.empty());
}

TEST(RoomWorld, who_cannot_be_placed_learns_why) {
  const auto placements = RoomWorld().place(report_of({placed("a", 1), lost("c")}), {});
  EXPECT_FALSE(placements[1].pose.is_placed());
  EXPECT_EQ(placements[1].pose.note, "turn it towards another");
}

}  // namespace
}  // namespace roomcast::alignment
