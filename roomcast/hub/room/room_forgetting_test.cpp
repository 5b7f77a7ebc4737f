// SPDX-License-Identifier: Apache-2.0
// The sensors that a Room remembers, and those that it removes to make room for others.
#include "roomcast/hub/room/room.h"
#include "roomcast/hub/room/room_test_fixture.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::IsEmpty;

TEST_F(RoomTest, unknown_names_keep_no_sensor_out) {
  for (std::size_t i = 0; i < 2 * wire::kMaxSensors; ++i) {
    (void)room.leave(enter(sensor_join("made up " + std::to_string(i), std::nullopt)), at(1s));
  }
  enter(sensor_join("left"), 2s);
  EXPECT_THAT(all<Disconnect>(actions), IsEmpty());
  EXPECT_EQ(room.online_sensor_count(), 1U);
  EXPECT_EQ(room.stats().sensors.size(), wire::kMaxSensors);
}

TEST_F(RoomTest, of_those_who_are_gone_and_have_no_place_the_longest_gone_makes_way) {
  actions = room.change({.name = "lab", .max_sensors = 3}, at(0s));
  const auto left = enter(sensor_join("left", std::nullopt));
  const auto right = enter(sensor_join("right", std::nullopt));
  const auto door = enter(sensor_join("door", std::nullopt));
  (void)room.leave(right, at(1s));
  (void)room.leave(left, at(2s));
  enter(viewer_join(), 3s);
  enter(sensor_join("window", std::nullopt), 4s);
  const auto roster = newest_roster(actions);
  std::vector<std::string> names;
  for (const auto& sensor : roster.sensors()) names.push_back(sensor.name());
  EXPECT_THAT(names, testing::UnorderedElementsAre("left", "door", "window"));
  EXPECT_EQ(all<RestartSensor>(actions).at(0).sensor, SensorId{1}) << "the id of who made way";
  (void)room.leave(door, at(5s));
}

TEST_F(RoomTest, who_has_a_place_that_was_found_keeps_it_while_gone) {
  actions = room.change({.name = "lab", .max_sensors = 1}, at(0s));
  const auto left = enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  (void)room.control(aligner, placement_of(0, 7), at(1s));
  (void)room.leave(left, at(2s));
  enter(sensor_join("right"), 3s);
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_ROOM_FULL);
  const auto forgotten = room.forget("left", at(4s));
  EXPECT_EQ(newest_roster(forgotten).sensors_size(), 0);
  enter(sensor_join("right"), 5s);
  EXPECT_THAT(all<Disconnect>(actions), IsEmpty());
}

TEST_F(RoomTest, who_was_forgotten_comes_back_as_a_new_one) {
  room.remember({.sensors = {{"left", SensorId{0}, stored_pose_at(7, 3)}}});
  (void)room.forget("left", at(0s));
  const auto left = enter(sensor_join("left", std::nullopt));
  EXPECT_FALSE(room.stats().sensors.at(0).pose.is_estimated());
  EXPECT_THAT(room.forget("left", at(1s)), IsEmpty()) << "it is here";
  EXPECT_EQ(room.stats().sensors.size(), 1U);
  (void)room.leave(left, at(2s));
  (void)room.forget("left", at(3s));
  EXPECT_TRUE(room.stats().sensors.empty());
}

TEST_F(RoomTest, what_was_found_of_who_had_the_id_before_is_too_late) {
  actions = room.change({.name = "lab", .max_sensors = 1}, at(0s));
  const auto left = enter(sensor_join("left", std::nullopt));
  pb::Control bundle;
  bundle.mutable_calibration_bundle();
  (void)room.control(left, bundle, at(1s));
  (void)room.leave(left, at(2s));
  enter(sensor_join("right", std::nullopt), 3s);
  const auto aligner = enter(aligner_join());
  (void)room.control(aligner, placement_from_bundle(1, 7), at(4s));
  EXPECT_FALSE(room.stats().sensors.at(0).pose.is_estimated());
  (void)room.control(aligner, placement_from_bundle(2, 7), at(5s));
  EXPECT_TRUE(room.stats().sensors.at(0).pose.is_estimated());
}

}  // namespace
}  // namespace roomcast::hub
