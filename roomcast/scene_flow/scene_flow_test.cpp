// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/scene_flow.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::scene_flow {
namespace {

using namespace std::chrono_literals;

CameraIntrinsics lens() {
  CameraIntrinsics lens;
  lens.width = 320;
  lens.height = 240;
  lens.fx = lens.fy = 300;
  lens.cx = 159.5;
  lens.cy = 119.5;
  return lens;
}

/// A ball of 30 cm radius before a wall at 4 m, its middle here (metres).
DepthImage ball(const Eigen::Vector3d& at_m) {
  const CameraIntrinsics camera = lens();
  DepthImage picture(camera.width, camera.height, 4000);
  constexpr double kRadius_m = 0.3;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1);
      const double along = ray.dot(at_m), size = ray.squaredNorm();
      const double root = along * along - size * (at_m.squaredNorm() - kRadius_m * kRadius_m);
      if (root < 0) continue;
      picture.at(x, y) =
          static_cast<std::uint16_t>(std::lround(1000 * (along - std::sqrt(root)) / size));
    }
  }
  return picture;
}

class BallBeforeWall : public ::testing::Test {
 protected:
  BallBeforeWall() {
    for (int i = 0; i < 10; ++i) take(DepthImage(lens().width, lens().height, 4000), 33ms);
  }

  void take(const DepthImage& picture, nanoseconds after) {
    time_ += after;
    flow_.take(picture, time_);
  }
  [[nodiscard]] const CellFlow& in_middle() const {
    return flow_.field().at(flow_.field().width() / 2, flow_.field().height() / 2);
  }

  SceneFlow flow_{lens()};
  RoomTime time_{};
};

TEST_F(BallBeforeWall, has_its_velocity) {
  take(ball({-0.05, 0.02, 2}), 33ms);
  take(ball({0, 0, 2.04}), 50ms);
  const CellFlow& flow = in_middle();
  EXPECT_NEAR(flow.velocity.x(), 1, 0.15);
  EXPECT_NEAR(flow.velocity.y(), -0.4, 0.15);
  EXPECT_NEAR(flow.velocity.z(), 0.8, 0.2);
  EXPECT_GT(flow.limit_m, 1.75);
  EXPECT_LT(flow.limit_m, 2.2) << "what is behind does not move with it";
}

TEST_F(BallBeforeWall, the_wall_does_not_move) {
  take(ball({-0.05, 0, 2}), 33ms);
  take(ball({0, 0, 2}), 50ms);
  EXPECT_EQ(flow_.field().at(2, 2).limit_m, 0);
}

TEST_F(BallBeforeWall, nobody_knows_how_it_moves_when_it_has_just_come) {
  take(ball({0, 0, 2}), 33ms);
  EXPECT_EQ(flow_.motion(), nullptr);
  take(ball({0.05, 0, 2}), 33ms);
  EXPECT_NE(flow_.motion(), nullptr);
}

TEST_F(BallBeforeWall, stands_still) {
  take(ball({0, 0, 2}), 33ms);
  take(ball({0, 0, 2}), 33ms);
  EXPECT_LT(in_middle().velocity.norm(), 0.02);
}

TEST_F(BallBeforeWall, a_rim_moves_with_what_it_belongs_to) {
  take(ball({-0.05, 0, 2}), 33ms);
  take(ball({0, 0, 2}), 50ms);
  const int rim = flow_.field().width() / 2 + 45 / kCellPixels + 1;  // of 45 pixels radius
  EXPECT_NEAR(flow_.field().at(rim, flow_.field().height() / 2).velocity.x(), 1, 0.3);
}

TEST_F(BallBeforeWall, nothing_is_known_of_one_picture_or_of_pictures_far_apart) {
  take(ball({0, 0, 2}), 33ms);
  take(ball({0.1, 0, 2}), 300ms);
  EXPECT_EQ(in_middle().limit_m, 0);
  take(ball({0.1, 0, 2}), 0ms);
  EXPECT_EQ(in_middle().limit_m, 0) << "taken at the same time";
  take(ball({0, 0, 2}), -33ms);
  EXPECT_EQ(in_middle().limit_m, 0) << "older";
}

TEST_F(BallBeforeWall, what_is_too_fast_is_not_believed) {
  take(ball({-0.1, 0, 2}), 33ms);
  take(ball({0, 0, 2}), 10ms);
  EXPECT_EQ(in_middle().limit_m, 0);
}

TEST(SceneFlow, nothing_moves_where_it_would_take_too_long_to_say_how) {
  CameraIntrinsics large = lens();
  large.width = 1024;
  large.height = 512;
  SceneFlow flow(large);
  DepthImage picture(large.width, large.height, 4000);
  RoomTime time{};
  for (int i = 0; i < 10; ++i) flow.take(picture, time += 33ms);
  const auto show_board = [&](int columns) {
    for (int y = 0; y < 400; ++y) {
      for (int x = 0; x < large.width; ++x) picture.at(x, y) = x < columns ? 2000 : 4000;
    }
    flow.take(picture, time += 33ms);
  };
  for (const int columns : {200, 204}) show_board(columns);  // 50 x 100 cells and more
  EXPECT_EQ(flow.motion(), nullptr);
  for (const int columns : {80, 84}) show_board(columns);
  EXPECT_NE(flow.motion(), nullptr);
}

TEST_F(BallBeforeWall, a_sensor_that_is_moved_shows_nothing_that_moves) {
  take(DepthImage(lens().width, lens().height, 3000), 33ms);
  take(DepthImage(lens().width, lens().height, 2900), 33ms);
  EXPECT_EQ(in_middle().limit_m, 0);
}

TEST_F(BallBeforeWall, is_not_known_to_move_in_a_picture_of_another_size) {
  take(ball({0, 0, 2}), 33ms);
  take(ball({0.033, 0, 2}), 33ms);
  EXPECT_NE(flow_.motion(), nullptr);
  take(DepthImage(lens().width / 2, lens().height, 4000), 33ms);
  EXPECT_EQ(flow_.motion(), nullptr);
}

}  // namespace
}  // namespace roomcast::scene_flow
