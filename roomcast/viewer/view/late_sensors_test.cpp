// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/late_sensors.h"

#include <chrono>

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

using std::chrono::milliseconds;

client::RoomSensor captured_at(std::uint16_t id, milliseconds time, double fps = 30) {
  client::RoomSensor sensor;
  sensor.id = SensorId{id};
  sensor.online = true;
  sensor.fps = fps;
  auto picture = std::make_shared<client::SensorPicture>();
  picture->capture_time = RoomTime(time);
  sensor.picture = picture;
  return sensor;
}

std::set<SensorId> late_of(std::vector<client::RoomSensor> sensors) {
  client::RoomSnapshot room;
  room.sensors = std::move(sensors);
  return late_sensors(room);
}

TEST(LateSensors, are_those_behind_the_newest_picture) {
  const milliseconds now(10'000);
  EXPECT_EQ(late_of({captured_at(1, now), captured_at(2, now - milliseconds(290)),
                     captured_at(3, now - milliseconds(310))}),
            std::set{SensorId{3}});
}

TEST(LateSensors, may_send_few_frames_a_second) {
  const milliseconds now(10'000);
  EXPECT_TRUE(late_of({captured_at(1, now), captured_at(2, now - milliseconds(900), 2)}).empty());
  EXPECT_FALSE(late_of({captured_at(1, now), captured_at(2, now - milliseconds(1300), 2)}).empty());
}

TEST(LateSensors, are_compared_with_those_that_send) {
  const milliseconds now(10'000);
  client::RoomSensor gone = captured_at(1, now), paused = captured_at(2, now);
  gone.online = false;
  paused.is_paused = true;
  client::RoomSensor silent = captured_at(3, now);
  silent.picture = nullptr;
  EXPECT_TRUE(late_of({gone, paused, silent, captured_at(4, milliseconds(0))}).empty());
  EXPECT_TRUE(late_of({}).empty());
}

}  // namespace
}  // namespace roomcast::viewer
