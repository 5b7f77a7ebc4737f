// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/messages.h"

#include <bit>
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/export/foxglove_messages.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::MessageReader;
using recording::ros::Serialisation;

constexpr nanoseconds kTime{1'700'000'000'123'456'789};
const CameraIntrinsics kCamera = {.width = 4,
                                  .height = 3,
                                  .fx = 5,
                                  .fy = 6,
                                  .cx = 1.5,
                                  .cy = 1,
                                  .k1 = 0.1,
                                  .k2 = 0.2,
                                  .k3 = 0.3,
                                  .p1 = 0.01,
                                  .p2 = 0.02};

TEST(Ros2Messages, pictures_are_read_back_bit_for_bit) {
  DepthImage depth(4, 3);
  for (int i = 0; i < 12; ++i) depth.data()[i] = static_cast<std::uint16_t>(257 * i);
  const Bytes message = depth_image(depth, "a_frame", kTime);
  const auto image = recording::ros::read_image(message, Serialisation::kRos2);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.stamp, kTime);
  EXPECT_EQ(image->header.frame_id, "a_frame");
  EXPECT_EQ(image->width, 4u);
  EXPECT_EQ(image->height, 3u);
  EXPECT_EQ(image->encoding, "16UC1");
  EXPECT_FALSE(image->is_bigendian);
  EXPECT_EQ(image->step, 8u);
  ASSERT_EQ(image->data.size(), 24u);
  EXPECT_EQ(std::memcmp(image->data.data(), depth.data(), 24), 0);
  const ColorImage color(4, 3, Rgb8{1, 2, 3});
  const Bytes in_color = color_image(color, "a_frame", kTime);
  const auto colored = recording::ros::read_image(in_color, Serialisation::kRos2);
  ASSERT_TRUE(colored);
  EXPECT_EQ(colored->encoding, "rgb8");
  EXPECT_EQ(colored->step, 12u);
  EXPECT_EQ(colored->data[35], 3);
}

TEST(Ros2Messages, part_of_a_picture_is_sent_without_the_rest) {
  DepthImage depth(4, 3);
  for (int i = 0; i < 12; ++i) depth.data()[i] = static_cast<std::uint16_t>(i);
  const DepthView right{depth.data() + 2, 2, 3, 4};
  const Bytes message = depth_image(right, "f", kTime);
  const auto image = recording::ros::read_image(message, Serialisation::kRos2);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->step, 4u);
  EXPECT_THAT(image->data, testing::ElementsAre(2, 0, 3, 0, 6, 0, 7, 0, 10, 0, 11, 0));
}

TEST(Ros2Messages, a_camera_has_its_lens) {
  const Bytes message = camera_info(kCamera, "f", kTime);
  const auto info = recording::ros::read_camera_info(message, Serialisation::kRos2);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->distortion_model, "plumb_bob");
  EXPECT_THAT(info->d, testing::ElementsAre(0.1, 0.2, 0.01, 0.02, 0.3));
  EXPECT_THAT(info->k, testing::ElementsAre(5, 0, 1.5, 0, 6, 1, 0, 0, 1));
  EXPECT_THAT(info->p, testing::ElementsAre(5, 0, 1.5, 0, 0, 6, 1, 0, 0, 0, 1, 0));
}

struct ReadCloud {
  std::uint32_t width = 0, height = 0;
  std::vector<std::string> fields;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
};

ReadCloud read_cloud(const Bytes& message) {
  MessageReader reader(message, Serialisation::kRos2);
  ReadCloud cloud;
  EXPECT_EQ(reader.header().stamp, kTime);
  cloud.height = reader.u32();
  cloud.width = reader.u32();
  for (std::uint32_t i = 0, count = reader.u32(); i < count; ++i) {
    cloud.fields.push_back(reader.text());
    EXPECT_EQ(reader.u32(), 4 * i);
    EXPECT_EQ(reader.u8(), 7);  // FLOAT32
    EXPECT_EQ(reader.u32(), 1u);
  }
  EXPECT_EQ(reader.u8(), 0);
  EXPECT_EQ(reader.u32(), 16u);
  EXPECT_EQ(reader.u32(), 16 * cloud.width);
  const auto data = reader.bytes();
  cloud.data.assign(data.begin(), data.end());
  cloud.is_dense = reader.u8() != 0;
  EXPECT_TRUE(reader.ok());
  return cloud;
}

float float_at(const ReadCloud& cloud, std::size_t offset) {
  float value = 0;
  std::memcpy(&value, cloud.data.data() + offset, sizeof(value));
  return value;
}

TEST(Ros2Messages, points_of_a_sensor_are_in_rows_and_missing_ones_are_not_numbers) {
  CameraIntrinsics camera = kCamera;
  camera.k1 = camera.k2 = camera.k3 = camera.p1 = camera.p2 = 0;
  DepthImage depth(4, 3, 2000);
  depth.at(0, 0) = 0;
  const ColorImage color(4, 3, Rgb8{1, 2, 3});
  const ReadCloud cloud = read_cloud(sensor_points(depth, color, ray_table(camera), "f", kTime));
  EXPECT_EQ(cloud.width, 4u);
  EXPECT_EQ(cloud.height, 3u);
  EXPECT_THAT(cloud.fields, testing::ElementsAre("x", "y", "z", "rgb"));
  EXPECT_FALSE(cloud.is_dense);
  ASSERT_EQ(cloud.data.size(), 12u * 16);
  EXPECT_TRUE(std::isnan(float_at(cloud, 8)));
  const std::size_t at = 16 * (2 * 4 + 3);  // x = 3, y = 2
  EXPECT_FLOAT_EQ(float_at(cloud, at), static_cast<float>((3 - 1.5) / 5 * 2));
  EXPECT_FLOAT_EQ(float_at(cloud, at + 4), static_cast<float>((2 - 1.0) / 6 * 2));
  EXPECT_FLOAT_EQ(float_at(cloud, at + 8), 2);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(float_at(cloud, at + 12)), 0x010203u);
  const ReadCloud grey = read_cloud(sensor_points(depth, {}, ray_table(camera), "f", kTime));
  EXPECT_EQ(std::bit_cast<std::uint32_t>(float_at(grey, at + 12)), 0u);
}

TEST(Ros2Messages, points_of_the_room_are_turned) {
  recording::PointCloud cloud;
  cloud.add({1, 2, 3}, {0, 0, 1}, {9, 8, 7});
  const RigidTransform z_up = recording::upright_from_world(recording::UpAxis::kZ);
  const ReadCloud read = read_cloud(world_points(cloud, z_up, kTime));
  EXPECT_EQ(read.width, 1u);
  EXPECT_TRUE(read.is_dense);
  EXPECT_FLOAT_EQ(float_at(read, 0), 1);
  EXPECT_FLOAT_EQ(float_at(read, 4), -3);
  EXPECT_FLOAT_EQ(float_at(read, 8), 2);
  EXPECT_EQ(read_cloud(world_points({}, z_up, kTime)).data.size(), 0u);
}

TEST(Ros2Messages, poses_are_transforms_from_the_world) {
  RigidTransform pose;
  pose.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  pose.translation_m = {1, 2, 3};
  const std::vector<FramePose> poses = {{"a", pose}, {"b", {}}};
  const Bytes message = transforms(poses, kTime);
  const auto read = recording::ros::read_transforms(message, Serialisation::kRos2);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].parent, "world");
  EXPECT_EQ((*read)[0].child, "a");
  EXPECT_THAT((*read)[0].parent_from_child.translation, testing::ElementsAre(1, 2, 3));
  EXPECT_NEAR(std::abs((*read)[0].parent_from_child.rotation_xyzw[0]), 1, 1e-12);
  EXPECT_EQ((*read)[1].parent_from_child.rotation_xyzw[3], 1);
}

}  // namespace
}  // namespace roomcast::ros2
