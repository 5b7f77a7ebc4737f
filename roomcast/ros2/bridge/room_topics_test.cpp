// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/room_topics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/ros/messages.h"
#include "roomcast/ros2/dds/dds_fixture.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::Serialisation;

class Ros2RoomTopics : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(topics->set_sensors(recording::wall_sensors()).ok()); }

  std::unique_ptr<Reader> reader(const std::string& name, const std::string& type,
                                 Quality quality = kSensorData) {
    return *participant->reader({name, type, quality});
  }
  /// Publishes until `reader` gets something; each time pictures that are new.
  Message first_message(Reader& reader) {
    Message message;
    EXPECT_TRUE(soon(*participant, [&] {
      EXPECT_TRUE(topics->publish(recording::wall_set()).ok());
      return (message = reader.take()) != nullptr;
    }));
    return message;
  }

  std::unique_ptr<Participant> participant = join_test_domain();
  std::unique_ptr<RoomTopics> topics = *RoomTopics::open(*participant, {});
};

TEST_F(Ros2RoomTopics, a_room_has_its_cloud_its_poses_and_five_topics_for_each_sensor) {
  EXPECT_THAT(
      topics->names(),
      testing::ElementsAre("/roomcast/far/color/camera_info", "/roomcast/far/color/image_raw",
                           "/roomcast/far/depth/camera_info", "/roomcast/far/depth/image_raw",
                           "/roomcast/far/points", "/roomcast/near/color/camera_info",
                           "/roomcast/near/color/image_raw", "/roomcast/near/depth/camera_info",
                           "/roomcast/near/depth/image_raw", "/roomcast/near/points",
                           "/roomcast/points", "/tf_static"));
}

TEST_F(Ros2RoomTopics, changes_are_counted_where_names_change) {
  const std::uint64_t begin = topics->changes();
  auto sensors = recording::wall_sensors();
  sensors[0].depth.fx += 1;
  ASSERT_TRUE(topics->set_sensors(sensors).ok());
  EXPECT_EQ(topics->changes(), begin) << "another lens";
  sensors.pop_back();
  ASSERT_TRUE(topics->set_sensors(sensors).ok());
  EXPECT_EQ(topics->changes(), begin + 1);
  ASSERT_TRUE(topics->set_sensors(recording::wall_sensors()).ok());
  EXPECT_EQ(topics->changes(), begin + 2);
}

TEST_F(Ros2RoomTopics, pictures_and_cameras_are_those_of_the_set) {
  const auto depths = reader("/roomcast/near/depth/image_raw", "sensor_msgs/msg/Image");
  const auto infos = reader("/roomcast/near/depth/camera_info", "sensor_msgs/msg/CameraInfo");
  const auto depth = recording::ros::read_image(*first_message(*depths), Serialisation::kRos2);
  ASSERT_TRUE(depth);
  EXPECT_EQ(depth->header.frame_id, "near_optical_frame");
  EXPECT_EQ(depth->width, 64u);
  EXPECT_EQ(depth->data[0] + 256 * depth->data[1], 2000);
  const auto info = recording::ros::read_camera_info(*first_message(*infos), Serialisation::kRos2);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->k[0], 60);
}

TEST_F(Ros2RoomTopics, points_of_the_room_are_sent_when_somebody_reads_them) {
  const auto points = reader("/roomcast/points", "sensor_msgs/msg/PointCloud2");
  EXPECT_GT(first_message(*points)->size(), 16u * 64 * 48 / 2);
  const auto of_one = reader("/roomcast/far/points", "sensor_msgs/msg/PointCloud2");
  EXPECT_GT(first_message(*of_one)->size(), 16u * 64 * 48);
}

TEST_F(Ros2RoomTopics, a_picture_is_sent_once) {
  const auto depths = reader("/roomcast/far/depth/image_raw", "sensor_msgs/msg/Image");
  const recording::FrameSet set = recording::wall_set();
  Message message;
  ASSERT_TRUE(soon(*participant, [&] {
    EXPECT_TRUE(topics->publish(recording::wall_set()).ok());
    return (message = depths->take()) != nullptr;
  }));
  while (depths->take()) {
  }
  ASSERT_TRUE(topics->publish(set).ok());
  ASSERT_TRUE(topics->publish(set).ok());
  ASSERT_TRUE(soon(*participant, [&] { return depths->take() != nullptr; }));
  EXPECT_EQ(depths->take(), nullptr);
}

TEST_F(Ros2RoomTopics, poses_are_latched_and_sent_again_when_they_change) {
  ASSERT_TRUE(topics->publish(recording::wall_set()).ok());
  const auto poses = reader("/tf_static", "tf2_msgs/msg/TFMessage", kStaticTransforms);
  Message message;
  const auto came = [&] { return (message = poses->take()) != nullptr; };
  ASSERT_TRUE(soon(*participant, came));  // sent before it was read
  const auto read = recording::ros::read_transforms(*message, Serialisation::kRos2);
  ASSERT_TRUE(read && read->size() == 2);
  EXPECT_EQ((*read)[1].child, "far_optical_frame");
  EXPECT_THAT((*read)[1].parent_from_child.translation, testing::ElementsAre(0.5, -2, 1));
  recording::FrameSet set = recording::wall_set();
  ASSERT_TRUE(topics->publish(set).ok());
  EXPECT_EQ(poses->take(), nullptr);
  set.frames[0].world_from_depth->translation_m.x() = 7;
  ASSERT_TRUE(topics->publish(set).ok());
  ASSERT_TRUE(soon(*participant, came));
}

TEST_F(Ros2RoomTopics, names_that_ros_has_not_are_changed_and_stay_different) {
  auto sensors = recording::wall_sensors();
  sensors[0].name = "left-hand";
  sensors[1].name = "left hand";
  ASSERT_TRUE(topics->set_sensors(sensors).ok());
  EXPECT_THAT(topics->names(), testing::Contains("/roomcast/left_hand/points"));
  EXPECT_THAT(topics->names(), testing::Contains("/roomcast/left_hand_2/points"));
  sensors.pop_back();
  ASSERT_TRUE(topics->set_sensors(sensors).ok());
  EXPECT_EQ(topics->names().size(), 7u);
}

TEST(Ros2RoomTopicsOptions, prefixes_are_names) {
  EXPECT_TRUE(RoomTopicsOptions{.prefix = "/lab/two"}.check().ok());
  EXPECT_TRUE(RoomTopicsOptions{.prefix = ""}.check().ok());
  EXPECT_FALSE(RoomTopicsOptions{.prefix = "lab"}.check().ok());
  EXPECT_FALSE(RoomTopicsOptions{.prefix = "/lab/"}.check().ok());
}

}  // namespace
}  // namespace roomcast::ros2
