// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/motion/room_motion.h"

#include <chrono>

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

constexpr SensorId kNear{1}, kFar{2};

CameraIntrinsics lens_of_board() {
  return {.width = 96, .height = 64, .fx = 90, .fy = 90, .cx = 47.5, .cy = 31.5};
}

/// A wall at 2 m and, from this column on if it is not 0, a board of 24x24 pixels at 1 m.
std::shared_ptr<const client::SensorPicture> picture_of(int board, RoomTime time) {
  auto picture = std::make_shared<client::SensorPicture>();
  DepthImage& depth_mm = picture->frame.depth_mm;
  depth_mm = DepthImage(lens_of_board().width, lens_of_board().height, 2000);
  for (int y = 20; board > 0 && y < 44; ++y) {
    for (int x = board; x < board + 24; ++x) depth_mm.at(x, y) = 1000;
  }
  picture->capture_time = time;
  return picture;
}

class MotionFinderTest : public ::testing::Test {
 protected:
  MotionFinderTest() {
    for (const SensorId id : {kNear, kFar}) {
      client::RoomSensor& sensor = room_.sensors.emplace_back();
      sensor.id = id;
      sensor.online = true;
      sensor.calibration.depth = lens_of_board();
    }
    for (int i = 0; i < 6; ++i) find(0, 0);
  }

  RoomMotion find(int near_board, int far_board) {
    time_ += 50ms;
    room_.sensors[0].picture = picture_of(near_board, time_);
    room_.sensors[1].picture = picture_of(far_board, time_);
    return finder_.find(room_);
  }

  client::RoomSnapshot room_;
  RoomTime time_{};
  MotionFinder finder_;
};

TEST_F(MotionFinderTest, tells_of_the_sensors_before_which_something_moves) {
  EXPECT_TRUE(find(20, 0).empty()) << "it has just come";
  const RoomMotion motion = find(24, 20);
  ASSERT_EQ(motion.size(), 1);
  EXPECT_GT(motion.at(kNear)->at(9, 8).velocity.x(), 0.4F);
  EXPECT_EQ(find(28, 24).size(), 2);
}

TEST_F(MotionFinderTest, keeps_the_motion_of_a_picture_that_is_still_the_newest) {
  find(20, 0);
  const RoomMotion motion = find(24, 0);
  room_.sensors[1].picture = picture_of(0, time_ += 50ms);
  EXPECT_EQ(finder_.find(room_).at(kNear), motion.at(kNear));
}

TEST_F(MotionFinderTest, finds_nothing_in_a_picture_of_another_size_than_the_lens) {
  find(20, 0);
  room_.sensors[0].calibration.depth.width = 48;
  EXPECT_TRUE(find(24, 0).empty());
  room_.sensors[0].picture = nullptr;
  EXPECT_TRUE(finder_.find(room_).empty());
}

TEST_F(MotionFinderTest, forgets_a_sensor_that_has_left) {
  find(20, 0);
  EXPECT_EQ(find(24, 0).size(), 1);
  room_.sensors.erase(room_.sensors.begin());
  EXPECT_TRUE(finder_.find(room_).empty());
}

}  // namespace
}  // namespace roomcast::viewer
