// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/sensor_list.h"

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

TEST(SensorList, gives_ids_in_the_order_of_joining) {
  SensorList sensors;
  EXPECT_EQ(sensors.add("left")->id, SensorId{0});
  EXPECT_EQ(sensors.add("right")->id, SensorId{1});
  EXPECT_EQ(sensors.find("left")->id, SensorId{0});
  EXPECT_EQ(sensors.find("door"), nullptr);
}

TEST(SensorList, gives_a_remembered_name_the_id_that_it_had) {
  SensorList sensors;
  sensors.remember({{"left", SensorId{0}}, {"right", SensorId{1}}});
  EXPECT_EQ(sensors.add("right")->id, SensorId{1});
  EXPECT_EQ(sensors.add("new")->id, SensorId{2});
  EXPECT_EQ(sensors.add("left")->id, SensorId{0});
}

TEST(SensorList, gives_remembered_ids_away_when_no_other_is_left) {
  SensorList sensors;
  std::vector<KnownSensor> earlier;
  for (std::uint16_t i = 0; i < wire::kMaxSensors; ++i) {
    earlier.push_back({"old" + std::to_string(i), SensorId{i}});
  }
  sensors.remember(earlier);
  EXPECT_EQ(sensors.add("new")->id, SensorId{0});
  EXPECT_EQ(sensors.add("old0")->id, SensorId{1});
  EXPECT_EQ(sensors.add("old5")->id, SensorId{5});
}

TEST(SensorList, gives_ids_of_those_with_a_place_away_last) {
  SensorList sensors;
  std::vector<KnownSensor> earlier;
  for (std::uint16_t i = 0; i < wire::kMaxSensors; ++i) {
    earlier.push_back({"old" + std::to_string(i), SensorId{i}, SensorPose{}});
  }
  earlier[5].pose.reset();
  sensors.remember(earlier);
  EXPECT_FALSE(sensors.would_displace("new"));
  EXPECT_EQ(sensors.add("new")->id, SensorId{5});
  EXPECT_TRUE(sensors.would_displace("newer"));
  EXPECT_FALSE(sensors.would_displace("old3"));
  EXPECT_EQ(sensors.add("newer")->id, SensorId{0});
}

TEST(SensorList, forgets_who_is_gone) {
  SensorList sensors;
  sensors.remember({{"right", SensorId{0}}});
  RoomSensor* left = sensors.add("left");
  sensors.connect(*left, ConnectionId{7});
  EXPECT_EQ(sensors.longest_gone(), nullptr);
  sensors.disconnect(*left);
  EXPECT_EQ(sensors.longest_gone(), left);
  EXPECT_TRUE(sensors.forget("left"));
  EXPECT_TRUE(sensors.forget("right"));
  EXPECT_FALSE(sensors.forget("left"));
  EXPECT_EQ(sensors.add("new")->id, SensorId{0});
}

TEST(SensorList, has_a_limit) {
  SensorList sensors;
  for (std::size_t i = 0; i < wire::kMaxSensors; ++i) {
    ASSERT_NE(sensors.add("s" + std::to_string(i)), nullptr);
  }
  EXPECT_EQ(sensors.add("one more"), nullptr);
  EXPECT_NE(sensors.find("s3"), nullptr);
}

TEST(SensorList, finds_a_sensor_behind_its_newest_connection_only) {
  SensorList sensors;
  RoomSensor* left = sensors.add("left");
  sensors.connect(*left, ConnectionId{7});
  sensors.connect(*left, ConnectionId{8});
  EXPECT_EQ(sensors.find(ConnectionId{7}), nullptr);
  EXPECT_EQ(sensors.find(ConnectionId{8}), left);
  EXPECT_EQ(sensors.online_count(), 1U);
  sensors.disconnect(*left);
  EXPECT_EQ(sensors.online_count(), 0U);
  EXPECT_EQ(sensors.find(ConnectionId{8}), nullptr);
  EXPECT_EQ(sensors.find(left->id), left);
  EXPECT_EQ(sensors.find(SensorId{9}), nullptr);
}

}  // namespace
}  // namespace roomcast::hub
