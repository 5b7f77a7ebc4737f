// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/room_problems.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

const HostTime kNow(1h);

client::RoomSensor good_sensor(const std::string& name) {
  client::RoomSensor sensor;
  sensor.name = name;
  sensor.online = true;
  sensor.pose.source = PoseSource::kGiven;
  sensor.pose.state = PoseState::kValid;
  sensor.fps = 30;
  auto picture = std::make_shared<client::SensorPicture>();
  picture->received = kNow - 20ms;
  sensor.picture = std::move(picture);
  return sensor;
}

client::RoomSnapshot good_room() {
  client::RoomSnapshot room;
  room.connected = true;
  room.sensors = {good_sensor("left"), good_sensor("right")};
  return room;
}

std::shared_ptr<client::SensorPicture> picture_from(nanoseconds ago) {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->received = kNow - ago;
  return picture;
}

TEST(RoomProblems, there_are_none_in_a_good_room) {
  EXPECT_TRUE(room_problems(good_room(), kNow).empty());
}

TEST(RoomProblems, a_lost_hub_is_the_only_one_that_matters) {
  client::RoomSnapshot room = good_room();
  room.sensors[0].online = false;
  room.connected = false;
  room.problem = "the connection to the hub ended: reset";
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].about, "hub");
  EXPECT_EQ(problems[0].sentence,
            "The hub is lost: the connection to the hub ended: reset. The last pictures are shown; "
            "it is tried again.");
}

TEST(RoomProblems, a_reason_that_asks_gets_no_full_stop) {
  client::RoomSnapshot room;
  room.problem = "no program listens at ws://lab:7600; is the hub running?\n";
  EXPECT_EQ(room_problems(room, kNow).at(0).sentence,
            "The hub is lost: no program listens at ws://lab:7600; is the hub running? The last "
            "pictures are shown; it is tried again.");
}

TEST(RoomProblems, a_slow_line_is_said_once_and_its_pictures_may_be_late) {
  client::RoomSnapshot room = good_room();
  for (client::RoomSensor& sensor : room.sensors) {
    sensor.is_small = true;
    sensor.picture = picture_from(5s);
  }
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, RoomProblem::Severity::kNotice);
  EXPECT_EQ(problems[0].sentence,
            "Your line is slow, so some sensors send coarser pictures and fewer of them.");
  room.sensors[0].picture = picture_from(12s);
  EXPECT_EQ(room_problems(room, kNow).at(0).sentence, "Sensor left has been silent for 12 s.");
}

TEST(RoomProblems, sensors_that_are_held_back_are_named_and_not_called_silent) {
  client::RoomSnapshot room = good_room();
  for (client::RoomSensor& sensor : room.sensors) sensor.is_small = true;
  room.sensors[1].is_held_back = true;
  room.sensors[1].picture = picture_from(60s);
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence,
            "Your line is too slow for all sensors: now and then only comes a picture of right.");
}

TEST(RoomProblems, a_small_picture_of_a_sensor_that_sends_no_more_says_nothing_of_the_line) {
  client::RoomSnapshot room = good_room();
  room.sensors[0].is_small = true;
  room.sensors[0].is_paused = true;
  EXPECT_TRUE(room_problems(room, kNow).empty());
  room.sensors[0].online = false;
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence, "Sensor left is gone.");
}

TEST(RoomProblems, a_sensor_that_left_is_named) {
  client::RoomSnapshot room = good_room();
  room.sensors[1].online = false;
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence, "Sensor right is gone.");
}

TEST(RoomProblems, a_silent_sensor_comes_before_one_without_a_place) {
  client::RoomSnapshot room = good_room();
  room.sensors[0].pose = {};
  room.sensors[0].pose.note = "it shares no surface with the others";
  room.sensors[1].picture = picture_from(5s);
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].sentence, "Sensor right has been silent for 5 s.");
  EXPECT_EQ(problems[1].sentence,
            "Sensor left is not placed yet: it shares no surface with the others. It is shown at a "
            "provisional place.");
}

TEST(RoomProblems, a_sensor_with_an_unverified_pose_is_reported) {
  client::RoomSnapshot room = good_room();
  room.sensors[0].pose.source = PoseSource::kStored;
  room.sensors[0].pose.state = PoseState::kUnverified;
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence,
            "Sensor left is shown at its stored pose, which has not been confirmed yet.");
}

TEST(RoomProblems, a_slow_sensor_is_not_a_silent_one) {
  client::RoomSnapshot room = good_room();
  room.sensors[1].fps = 0.5;
  room.sensors[1].picture = picture_from(5s);
  EXPECT_TRUE(room_problems(room, kNow).empty());
}

TEST(RoomProblems, an_empty_room_and_one_whose_sensors_all_left_differ) {
  client::RoomSnapshot room;
  room.connected = true;
  EXPECT_EQ(room_problems(room, kNow).at(0).sentence, "No sensor is in the room yet.");
  room = good_room();
  for (client::RoomSensor& sensor : room.sensors) sensor.online = false;
  EXPECT_EQ(room_problems(room, kNow).at(0).sentence, "All sensors are gone.");
}

TEST(RoomProblems, a_moved_sensor_and_one_that_has_sent_nothing_are_reported) {
  client::RoomSnapshot room = good_room();
  room.sensors[0].pose.state = PoseState::kMoved;
  room.sensors[1].picture.reset();
  const auto problems = room_problems(room, kNow);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_NE(problems[0].sentence.find("was moved"), std::string::npos);
  EXPECT_NE(problems[1].sentence.find("has not sent a picture"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::viewer
