// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <gtest/gtest.h>

#include "roomcast/align/made_up_room.h"

namespace roomcast::aligner {
namespace {

RigidTransform at(double x) {
  RigidTransform pose;
  pose.translation_m = {x, 1, 0};
  return pose;
}

align::AlignmentReport report_of(std::vector<align::SensorReport> sensors) {
  align::AlignmentReport report;
  report.sensors = std::move(sensors);
  return report;
}

align::SensorReport placed(const std::string& id, double x) {
  align::SensorReport sensor;
  sensor.id = id;
  sensor.placed = true;
  sensor.world_from_depth = at(x);
  return sensor;
}

double x_of(const Placement& placement) {
  return placement.world_from_depth->translation_m.x();
}

TEST(RoomPlacing, without_a_known_pose_the_world_is_the_reports) {
  const auto placements = placements_in_place(report_of({placed("a", 1), placed("b", 3)}), {}, {});
  EXPECT_EQ(x_of(placements[0]), 1);
  EXPECT_EQ(x_of(placements[1]), 3);
}

TEST(RoomPlacing, a_sensor_that_was_found_before_stays_and_the_others_come_to_it) {
  const auto placements =
      placements_in_place(report_of({placed("a", 1), placed("b", 3)}), {}, {{"b", at(10)}});
  EXPECT_EQ(x_of(placements[0]), 8);
  EXPECT_EQ(x_of(placements[1]), 10);
}

TEST(RoomPlacing, a_given_pose_goes_before_one_that_was_found) {
  const auto placements = placements_in_place(report_of({placed("a", 1), placed("b", 3)}),
                                              {{"b", at(20)}}, {{"a", at(1)}});
  EXPECT_EQ(x_of(placements[0]), 18);
  EXPECT_EQ(x_of(placements[1]), 20);
}

TEST(RoomPlacing, one_that_was_moved_unnoticed_does_not_take_the_room_along) {
  const KnownPoses before = {{"a", at(1)}, {"b", at(3)}, {"c", at(5)}};
  const auto placements = placements_in_place(
      report_of({placed("a", 0), placed("b", 2.5), placed("c", 4.5)}), {}, before);
  EXPECT_DOUBLE_EQ(x_of(placements[0]), 0.5);
  EXPECT_DOUBLE_EQ(x_of(placements[1]), 3);
  EXPECT_DOUBLE_EQ(x_of(placements[2]), 5);
}

TEST(RoomPlacing, who_cannot_be_placed_is_told_why) {
  align::SensorReport lost;
  lost.id = "c";
  lost.reason = "turn it towards another";
  const auto placements = placements_in_place(report_of({placed("a", 1), lost}), {}, {});
  EXPECT_FALSE(placements[1].world_from_depth);
  EXPECT_EQ(placements[1].note, "turn it towards another");
}

TEST(RoomPlacing, a_view_of_no_use_is_reported) {
  auto dark = align::made_up_bundle({}, "dark", align::corner_pose(2, 1.5));
  dark.color = ColorImage(dark.color.width(), dark.color.height());
  RoomPlacing placing;
  placing.add(dark);
  const auto placements = placing.solve({}, {});
  ASSERT_EQ(placements.size(), 1U);
  EXPECT_EQ(placements[0].sensor, "dark");
  EXPECT_FALSE(placements[0].note.empty());
}

}  // namespace
}  // namespace roomcast::aligner
