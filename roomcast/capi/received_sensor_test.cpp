// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/received_sensor.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>

namespace roomcast::capi {
namespace {

client::RoomSensor sensor_with_picture() {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->frame = {DepthImage(2, 2, 1000), ColorImage(2, 2), MaskImage(2, 2)};
  client::RoomSensor sensor;
  sensor.online = true;
  sensor.calibration.depth = {.width = 2, .height = 2, .fx = 2, .fy = 2, .cx = 0.5, .cy = 0.5};
  sensor.picture = std::move(picture);
  return sensor;
}

TEST(ReceivedSensor, sensors_that_are_away_or_without_a_picture_are_left_out) {
  client::RoomSnapshot room;
  room.sensors = {sensor_with_picture(), sensor_with_picture(), sensor_with_picture()};
  room.sensors[0].online = false;
  room.sensors[1].picture = nullptr;
  SensorRays rays;
  const auto received = received_sensors(room, rays);
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].sensor, &room.sensors[2]);
}

TEST(ReceivedSensor, a_picture_is_handed_on_without_a_copy) {
  client::RoomSnapshot room;
  room.sensors = {sensor_with_picture()};
  SensorRays rays;
  EXPECT_EQ(received_sensors(room, rays)[0].frame.get(), &room.sensors[0].picture->frame);
}

TEST(SensorRays, are_worked_out_anew_for_another_calibration_only) {
  client::RoomSensor sensor = sensor_with_picture();
  SensorRays rays;
  const auto first = rays.of(sensor);
  EXPECT_EQ(rays.of(sensor), first);
  sensor.calibration.depth.fx = 4;
  const auto second = rays.of(sensor);
  EXPECT_NE(second, first);
  EXPECT_FLOAT_EQ(second->at(1, 0).x(), 0.125F);
}

}  // namespace
}  // namespace roomcast::capi
