// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/room_points.h"

#include <array>
#include <memory>

#include <gtest/gtest.h>

namespace roomcast::capi {
namespace {

constexpr CameraIntrinsics kCamera{.width = 3, .height = 2, .fx = 2, .fy = 2, .cx = 1, .cy = 0.5};

/// A pose at (5, 1, 0) whose optical axis (z) points along world x.
RigidTransform looking_along_x() {
  RigidTransform world_from_depth;
  world_from_depth.rotation << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  world_from_depth.translation_m = {5, 1, 0};
  return world_from_depth;
}

client::RoomSensor sensor_that_sees(const DepthImage& depth_mm, const ColorImage& color) {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->frame = {depth_mm, color, MaskImage(3, 2, 255)};
  client::RoomSensor sensor;
  sensor.id = SensorId{7};
  sensor.online = true;
  sensor.pose.source = PoseSource::kGiven;
  sensor.pose.state = PoseState::kValid;
  sensor.calibration.depth = kCamera;
  sensor.pose.world_from_depth = looking_along_x();
  sensor.picture = std::move(picture);
  return sensor;
}

DepthImage one_reading() {
  DepthImage depth_mm(3, 2);
  depth_mm.at(2, 1) = 4000;
  return depth_mm;
}

struct RoomPointsTest : testing::Test {
  std::size_t points_of(client::RoomSensor sensor) {
    room.sensors = {std::move(sensor)};
    return write_points(received_sensors(room, rays), out);
  }
  client::RoomSnapshot room;
  SensorRays rays;
  std::array<roomcast_point, 4> out{};
};

TEST_F(RoomPointsTest, a_reading_is_a_point_of_the_world_in_its_colour) {
  ColorImage color(3, 2);
  color.at(2, 1) = {10, 20, 30};
  ASSERT_EQ(points_of(sensor_that_sees(one_reading(), color)), 1u);
  // The ray is (0.5, 0.25, 1), so the sensor sees it at (2, 1, 4).
  EXPECT_FLOAT_EQ(out[0].x, 9);
  EXPECT_FLOAT_EQ(out[0].y, 0);
  EXPECT_FLOAT_EQ(out[0].z, 2);
  EXPECT_EQ(out[0].r, 10);
  EXPECT_EQ(out[0].g, 20);
  EXPECT_EQ(out[0].b, 30);
  EXPECT_EQ(out[0].a, 255);
}

TEST_F(RoomPointsTest, finer_colour_is_the_mean_of_its_pixels) {
  ColorImage color(6, 4);
  for (int y = 2; y < 4; ++y) {
    for (int x = 4; x < 6; ++x)
      color.at(x, y) = {static_cast<std::uint8_t>(x == 4 ? 40 : 60), 0, 0};
  }
  ASSERT_EQ(points_of(sensor_that_sees(one_reading(), color)), 1u);
  EXPECT_EQ(out[0].r, 50);
}

TEST_F(RoomPointsTest, without_colour_points_are_grey) {
  ASSERT_EQ(points_of(sensor_that_sees(one_reading(), {})), 1u);
  EXPECT_EQ(out[0].r, 128);
}

TEST_F(RoomPointsTest, points_for_which_there_is_no_room_are_counted) {
  EXPECT_EQ(points_of(sensor_that_sees(DepthImage(3, 2, 1000), {})), 6u);
  EXPECT_EQ(out[3].a, 255);
}

TEST_F(RoomPointsTest, an_unplaced_sensor_gives_no_points) {
  client::RoomSensor sensor = sensor_that_sees(one_reading(), {});
  sensor.pose.source = PoseSource::kNone;
  EXPECT_EQ(points_of(std::move(sensor)), 0u);
}

}  // namespace
}  // namespace roomcast::capi
