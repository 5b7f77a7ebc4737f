// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/speaker.h"

#include <gtest/gtest.h>

#include "roomcast/wire/audio_header.h"

namespace roomcast::client {
namespace {

RoomSnapshot room_of_two() {
  RoomSnapshot room;
  RoomSensor& left = room.sensors.emplace_back();
  left.id = SensorId{3};
  left.name = "left";
  left.pose.world_from_depth.translation_m = {1, 2, 3};
  RoomPerson& ada = room.people.emplace_back();
  ada.id = ViewerId{3};
  ada.name = "Ada";
  return room;
}

TEST(Speaker, a_sensor_is_heard_from_where_it_stands) {
  const RoomSnapshot room = room_of_two();
  const ViewerId speaker = wire::speaker_of(SensorId{3});
  EXPECT_EQ(sensor_of_speaker(speaker), SensorId{3});
  EXPECT_FALSE(sensor_of_speaker(ViewerId{3}));
  EXPECT_TRUE(speaker_is_here(room, speaker));
  EXPECT_EQ(speaker_name(room, speaker), "left");
  const auto place = world_from_speaker(room, speaker);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->translation_m, Eigen::Vector3d(1, 2, 3));
  // The room's sensor looks along z and has y down.
  EXPECT_EQ(place->rotation * Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(place->rotation * Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0));
}

TEST(Speaker, a_person_is_heard_from_the_head) {
  RoomSnapshot room = room_of_two();
  EXPECT_EQ(speaker_name(room, ViewerId{3}), "Ada");
  EXPECT_FALSE(world_from_speaker(room, ViewerId{3})) << "it has sent no pose yet";
  room.people[0].pose.emplace().world_from_head.translation_m = {0, 1.7, 0};
  EXPECT_EQ(world_from_speaker(room, ViewerId{3})->translation_m, Eigen::Vector3d(0, 1.7, 0));
}

TEST(Speaker, nobody_is_known_under_another_id) {
  const RoomSnapshot room = room_of_two();
  for (const ViewerId other : {ViewerId{4}, wire::speaker_of(SensorId{4}), ViewerId{0xFFFF'FFFF}}) {
    EXPECT_FALSE(speaker_is_here(room, other));
    EXPECT_EQ(speaker_name(room, other), "");
    EXPECT_FALSE(world_from_speaker(room, other));
  }
}

}  // namespace
}  // namespace roomcast::client
