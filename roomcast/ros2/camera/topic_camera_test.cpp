// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/camera/topic_camera.h"

#include <cstdlib>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/ros/ros_fixture.h"
#include "roomcast/ros2/dds/dds_fixture.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::Serialisation;

constexpr int kWidth = 8, kHeight = 6;
constexpr const char* kDepth = "/camera/depth/image_raw";
constexpr const char* kColor = "/camera/color/image_raw";

/// A node of ROS 2 with a camera: sends what a test gives it, 100 times a second, until its end.
class CameraNode {
 public:
  using Make = std::function<std::string(nanoseconds stamp)>;
  ~CameraNode() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
  }
  void sends(const std::string& topic, const std::string& type, Make make) {
    writers_.push_back({*participant_->writer({topic, type, kSensorData}), std::move(make)});
  }
  void sends_once(const std::string& topic, const std::string& type, const std::string& text) {
    latched_.push_back(*participant_->writer({topic, type, kStaticTransforms}));
    ASSERT_TRUE(latched_.back()->write(bytes_of(text)).ok());
  }
  void start() {
    thread_ = std::jthread([this](const std::stop_token& stop) {
      for (nanoseconds stamp(1'700'000'000'000'000'000); !stop.stop_requested();
           stamp += std::chrono::milliseconds(10)) {
        for (auto& [writer, make] : writers_) (void)writer->write(bytes_of(make(stamp)));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
  }

 private:
  static std::vector<std::uint8_t> bytes_of(const std::string& text) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
    return bytes;
  }
  std::unique_ptr<Participant> participant_ = join_test_domain();
  std::vector<std::pair<std::unique_ptr<Writer>, Make>> writers_;
  std::vector<std::unique_ptr<Writer>> latched_;
  std::jthread thread_;
};

std::string depth_picture(nanoseconds stamp, int width = kWidth) {
  std::string pixels;
  for (int i = 0; i < width * kHeight; ++i) pixels += {static_cast<char>(i), 4};
  return image_message(Serialisation::kRos2, stamp, "depth_frame", width, kHeight, "16UC1",
                       2 * width, pixels);
}

std::string color_picture(nanoseconds stamp) {
  return image_message(Serialisation::kRos2, stamp, "color_frame", kWidth, kHeight, "bgr8",
                       3 * kWidth, std::string(3 * kWidth * kHeight, 'c'));
}

std::string camera(const std::string& frame, double focal) {
  return camera_info_message(Serialisation::kRos2, frame, kWidth, kHeight, focal, "plumb_bob",
                             {0.1, 0, 0, 0, 0});
}

class Ros2TopicCamera : public testing::Test {
 protected:
  Ros2TopicCamera() {
    setenv("ROS_DOMAIN_ID", std::to_string(test_domain()).c_str(), 1);
    setenv("ROS_LOCALHOST_ONLY", "1", 1);
  }
  ~Ros2TopicCamera() override {
    unsetenv("ROS_DOMAIN_ID");
    unsetenv("ROS_LOCALHOST_ONLY");
  }
  void send_depth() {
    node.sends(kDepth, "sensor_msgs/msg/Image", [](nanoseconds s) { return depth_picture(s); });
    node.sends("/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo",
               [](nanoseconds) { return camera("depth_frame", 10); });
  }
  void send_color() {
    node.sends(kColor, "sensor_msgs/msg/Image", [](nanoseconds s) { return color_picture(s); });
    node.sends("/camera/color/camera_info", "sensor_msgs/msg/CameraInfo",
               [](nanoseconds) { return camera("color_frame", 12); });
  }
  Result<std::unique_ptr<source::Camera>> open(const std::string& place,
                                               std::chrono::milliseconds patience) {
    return topic_camera_backend({.patience = patience})->open({place, "", ""}, {});
  }
  Result<std::unique_ptr<source::Camera>> open(const std::string& place) {
    return open(place, std::chrono::seconds(10));
  }
  std::string refusal(const std::string& place) {
    const auto opened = open(place, std::chrono::milliseconds(1000));
    return opened ? "it was opened" : opened.error().message;
  }

  CameraNode node;
};

TEST_F(Ros2TopicCamera, depth_alone_is_a_camera) {
  send_depth();
  node.start();
  const auto opened = open(kDepth);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  const auto& description = (*opened)->description();
  EXPECT_FALSE(description.has_color);
  EXPECT_EQ(description.calibration.depth.fx, 10);
  EXPECT_EQ(description.calibration.depth.k1, 0.1);
  EXPECT_NEAR(description.fps, 100, 1);
  std::vector<source::CapturedFrame> frames;
  source::FramePairing pairing(description.fps, false,
                               [&](source::CapturedFrame& frame) { frames.push_back(frame); });
  for (int i = 0; i < 1000 && frames.size() < 3; ++i)
    ASSERT_TRUE((*opened)->wait(pairing, std::chrono::milliseconds(10)).ok());
  ASSERT_GE(frames.size(), 3u);
  EXPECT_EQ(frames[0].depth_mm.at(3, 1), 4 * 256 + kWidth + 3);
  EXPECT_GE(frames[0].device_time, nanoseconds(1'700'000'000'000'000'000));
}

TEST_F(Ros2TopicCamera, colour_comes_with_its_place) {
  send_depth();
  send_color();
  node.sends_once("/tf_static", "tf2_msgs/msg/TFMessage",
                  transforms_message(Serialisation::kRos2, {{"base", "depth_frame", {0, 0, 0}},
                                                            {"base", "color_frame", {0.1, 0, 0}}}));
  node.start();
  const auto opened = open(std::string(kDepth) + "," + kColor);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  const auto& description = (*opened)->description();
  EXPECT_TRUE(description.has_color);
  EXPECT_EQ(description.calibration.color.fx, 12);
  EXPECT_FALSE(description.calibration.color_is_registered);
  EXPECT_NEAR(description.calibration.color_from_depth.translation_m.x(), -0.1, 1e-12);
  int frames = 0;
  source::FramePairing pairing(description.fps, true, [&](source::CapturedFrame& frame) {
    ++frames;
    EXPECT_EQ(frame.color.at(0, 0), (Rgb8{'c', 'c', 'c'}));
  });
  for (int i = 0; i < 1000 && frames < 3; ++i)
    ASSERT_TRUE((*opened)->wait(pairing, std::chrono::milliseconds(10)).ok());
  EXPECT_GE(frames, 3);
}

TEST_F(Ros2TopicCamera, a_topic_that_never_comes_is_a_sentence) {
  EXPECT_THAT(refusal(kDepth),
              testing::StartsWith("nothing came on /camera/depth/camera_info; does the camera's "
                                  "node run, in ROS_DOMAIN_ID " +
                                  std::to_string(test_domain()) + " on this computer?"));
  node.sends("/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo",
             [](nanoseconds) { return camera("depth_frame", 10); });
  node.start();
  EXPECT_THAT(refusal(kDepth), testing::StartsWith("nothing came on /camera/depth/image_raw"));
}

TEST_F(Ros2TopicCamera, colour_without_a_known_place_is_a_sentence) {
  send_depth();
  send_color();
  node.start();
  EXPECT_EQ(refusal(std::string(kDepth) + "," + kColor),
            "/tf_static does not say where color_frame is from depth_frame");
}

TEST_F(Ros2TopicCamera, damaged_messages_and_wrong_sizes_are_refused) {
  node.sends(kDepth, "sensor_msgs/msg/Image",
             [](nanoseconds stamp) { return depth_picture(stamp).substr(0, 60); });
  node.sends("/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo",
             [](nanoseconds) { return camera("depth_frame", 10); });
  node.sends("/wide/image_raw", "sensor_msgs/msg/Image",
             [](nanoseconds stamp) { return depth_picture(stamp, kWidth + 2); });
  node.sends("/wide/camera_info", "sensor_msgs/msg/CameraInfo",
             [](nanoseconds) { return camera("depth_frame", 10); });
  node.sends("/no_info/image_raw", "sensor_msgs/msg/Image",
             [](nanoseconds stamp) { return depth_picture(stamp); });
  node.sends("/no_info/camera_info", "sensor_msgs/msg/CameraInfo",
             [](nanoseconds) { return camera("depth_frame", 10).substr(0, 50); });
  node.start();
  EXPECT_EQ(refusal(kDepth), "/camera/depth/image_raw: a message is damaged");
  EXPECT_EQ(refusal("/wide/image_raw"),
            "/wide/image_raw: a picture in it has another size than its camera_info");
  EXPECT_THAT(refusal("/no_info/image_raw"),
              testing::StartsWith("nothing came on /no_info/camera_info"));
}

TEST_F(Ros2TopicCamera, a_camera_that_changes_its_size_counts_as_lost) {
  bool is_wide = false;
  std::mutex mutex;
  node.sends(kDepth, "sensor_msgs/msg/Image", [&](nanoseconds stamp) {
    const std::lock_guard lock(mutex);
    return depth_picture(stamp, is_wide ? kWidth + 2 : kWidth);
  });
  node.sends("/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo",
             [](nanoseconds) { return camera("depth_frame", 10); });
  node.start();
  const auto opened = open(kDepth);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  {
    const std::lock_guard lock(mutex);
    is_wide = true;
  }
  source::FramePairing pairing(30, false, [](source::CapturedFrame&) {});
  Status status;
  for (int i = 0; i < 1000 && status; ++i)
    status = (*opened)->wait(pairing, std::chrono::milliseconds(10));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

TEST_F(Ros2TopicCamera, what_is_no_topic_is_refused_at_once) {
  for (const char* place : {"", "camera", "/camera/", "/a,/b/", "/a,b"})
    EXPECT_THAT(refusal(place), testing::HasSubstr("is not the name of a ROS 2 topic")) << place;
}

TEST(Ros2TopicCameraName, is_that_of_the_namespace) {
  EXPECT_EQ(camera_name_of_topic("/camera/depth/image_raw,/x/y"), "camera");
  EXPECT_EQ(camera_name_of_topic("/depth"), "ros2");
  EXPECT_EQ(camera_name_of_topic(""), "ros2");
}

}  // namespace
}  // namespace roomcast::ros2
