// SPDX-License-Identifier: Apache-2.0
// tests/cli/export.test.mjs compares the schemas with the published ones.
#include "roomcast/recording/export/foxglove_messages.h"

#include <cstring>

#include <Eigen/Geometry>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/foxglove/foxglove.pb.h"

namespace roomcast::recording {
namespace {

constexpr nanoseconds kNoon{1'764'072'000'000'000'123};

template <class Message>
Message parsed(const std::string& bytes) {
  Message message;
  EXPECT_TRUE(message.ParseFromString(bytes));
  return message;
}

Eigen::Vector3f point_of(const foxglove::PointCloud& message, std::size_t i) {
  Eigen::Vector3f point;
  std::memcpy(point.data(), message.data().data() + i * message.point_stride(), 12);
  return point;
}

TEST(FoxgloveMessages, a_time_is_kept_to_the_nanosecond) {
  const auto message =
      parsed<foxglove::CameraCalibration>(camera_message(wall_sensors()[0], kNoon));
  EXPECT_EQ(message.timestamp().seconds(), 1'764'072'000);
  EXPECT_EQ(message.timestamp().nanos(), 123);
}

TEST(FoxgloveMessages, depth_is_16_bit_millimetres_row_by_row) {
  DepthImage wide(5, 2, 0);
  wide.at(0, 0) = 1234;
  wide.at(2, 1) = 65'535;
  const DepthView left{wide.data(), 3, 2, 5};  // rows with a gap
  const auto message = parsed<foxglove::RawImage>(depth_message("s0", left, kNoon));
  EXPECT_EQ(message.encoding(), "16UC1");
  EXPECT_EQ(message.width(), 3u);
  EXPECT_EQ(message.height(), 2u);
  EXPECT_EQ(message.step(), 6u);
  ASSERT_EQ(message.data().size(), 12u);
  std::uint16_t pixels[6];
  std::memcpy(pixels, message.data().data(), sizeof pixels);
  EXPECT_EQ(pixels[0], 1234);
  EXPECT_EQ(pixels[1], 0);
  EXPECT_EQ(pixels[5], 65'535);
}

TEST(FoxgloveMessages, a_world_with_z_up_is_turned_and_not_mirrored) {
  const RigidTransform upright = upright_from_world(UpAxis::kZ);
  EXPECT_EQ(upright * Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1));
  EXPECT_DOUBLE_EQ(upright.rotation.determinant(), 1);
  EXPECT_TRUE(upright_from_world(UpAxis::kY).rotation.isIdentity(0));
}

TEST(FoxgloveMessages, points_and_poses_are_turned_alike) {
  const Eigen::Vector3d in_depth(0.25, -0.5, 2);
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    PointCloud cloud;
    cloud.add((wall_pose(1) * in_depth).cast<float>(), {0, 0, 1}, {10, 20, 30});
    const auto points = parsed<foxglove::PointCloud>(points_message(cloud, up, kNoon));
    const auto pose =
        parsed<foxglove::FrameTransform>(transform_message("far", wall_pose(1), up, kNoon));
    const Eigen::Quaterniond rotation(pose.rotation().w(), pose.rotation().x(), pose.rotation().y(),
                                      pose.rotation().z());
    const Eigen::Vector3d by_pose =
        rotation * in_depth +
        Eigen::Vector3d(pose.translation().x(), pose.translation().y(), pose.translation().z());
    EXPECT_LT((point_of(points, 0).cast<double>() - by_pose).norm(), 1e-6);
    EXPECT_EQ(pose.parent_frame_id(), points.frame_id());
    EXPECT_EQ(pose.child_frame_id(), "far");
    const auto* colors = reinterpret_cast<const std::uint8_t*>(points.data().data()) + 12;
    EXPECT_EQ(colors[0], 30);
    EXPECT_EQ(colors[2], 10);
    EXPECT_EQ(colors[3], 255);
  }
}

TEST(FoxgloveMessages, the_poses_of_a_set_are_one_message) {
  const NamedPose poses[] = {{"near", wall_pose(0)}, {"far", wall_pose(1)}};
  const auto all = parsed<foxglove::FrameTransforms>(transforms_message(poses, UpAxis::kZ, kNoon));
  ASSERT_EQ(all.transforms_size(), 2);
  EXPECT_EQ(all.transforms(1).SerializeAsString(),
            transform_message("far", wall_pose(1), UpAxis::kZ, kNoon));
}

TEST(FoxgloveMessages, a_schema_contains_the_files_it_needs) {
  const FoxgloveSchema schema = foxglove_schema(FoxgloveKind::kDepth);
  EXPECT_EQ(schema.name, "foxglove.RawImage");
  const auto files = parsed<google::protobuf::FileDescriptorSet>(schema.files);
  ASSERT_EQ(files.file_size(), 2);
  EXPECT_EQ(files.file(0).name(), "google/protobuf/timestamp.proto");
}

TEST(FoxgloveMessages, pictures_name_their_format_and_frame) {
  const std::uint8_t bytes[] = {1, 2, 3};
  const auto video = parsed<foxglove::CompressedVideo>(video_message("s0", bytes, kNoon));
  EXPECT_EQ(video.format(), "vp9");
  const auto image = parsed<foxglove::CompressedImage>(jpeg_message("s1", bytes, kNoon));
  EXPECT_EQ(image.format(), "jpeg");
  EXPECT_EQ(image.frame_id(), "s1");
  EXPECT_EQ(image.data(), "\1\2\3");
}

}  // namespace
}  // namespace roomcast::recording
