// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/room_flow.h"

#include <chrono>

#include <gtest/gtest.h>

namespace roomcast::scene_flow {
namespace {

using namespace std::chrono_literals;

constexpr SensorId kLeft{1}, kRight{2};

CameraIntrinsics small_lens() {
  return {.width = 96, .height = 64, .fx = 90, .fy = 90, .cx = 47.5, .cy = 31.5};
}

/// A board of 24x24 pixels, 1 m away, before a wall at 2 m.
DepthImage board_at(int left) {
  DepthImage picture(small_lens().width, small_lens().height, 2000);
  for (int y = 20; y < 44; ++y) {
    for (int x = left; x < left + 24; ++x) picture.at(x, y) = 1000;
  }
  return picture;
}

class RoomFlowTest : public ::testing::Test {
 protected:
  RoomFlowTest() {
    const DepthImage wall(small_lens().width, small_lens().height, 2000);
    for (int i = 0; i < 6; ++i) take(kLeft, wall, 50ms);
  }
  const FlowField* take(SensorId sensor, const DepthImage& picture, nanoseconds after,
                        const CameraIntrinsics& lens = small_lens()) {
    return flow_.take(sensor, lens, picture, time_ += after);
  }

  RoomFlow flow_;
  RoomTime time_{};
};

TEST_F(RoomFlowTest, what_moves_is_found_for_the_sensor_that_sees_it) {
  EXPECT_EQ(take(kLeft, board_at(20), 50ms), nullptr) << "it has just come";
  const FlowField* moves = take(kLeft, board_at(24), 50ms);
  ASSERT_NE(moves, nullptr);
  EXPECT_GT(moves->at(36 / kCellPixels, 32 / kCellPixels).velocity.x(), 0.4F);
  EXPECT_EQ(take(kRight, board_at(24), 0ms), nullptr);
}

TEST_F(RoomFlowTest, a_picture_that_is_shown_again_moves_as_before) {
  take(kLeft, board_at(20), 50ms);
  const FlowField* moves = take(kLeft, board_at(24), 50ms);
  EXPECT_EQ(take(kLeft, board_at(24), 0ms), moves);
  EXPECT_NE(take(kLeft, board_at(28), 50ms), nullptr);
}

TEST_F(RoomFlowTest, a_sensor_begins_anew_with_another_lens_or_after_it_was_forgotten) {
  take(kLeft, board_at(20), 50ms);
  CameraIntrinsics other = small_lens();
  other.fx = 91;
  EXPECT_EQ(take(kLeft, board_at(24), 50ms, other), nullptr);
  take(kLeft, board_at(24), 50ms);
  flow_.forget(kLeft);
  EXPECT_EQ(take(kLeft, board_at(28), 50ms), nullptr);
}

}  // namespace
}  // namespace roomcast::scene_flow
