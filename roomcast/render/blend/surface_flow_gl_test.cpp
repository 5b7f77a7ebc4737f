// SPDX-License-Identifier: Apache-2.0
// Tests that what moves is drawn where it is at the chosen instant.
#include <chrono>
#include <optional>

#include "roomcast/render/blend/surface_flow.h"
#include "roomcast/render/room_fixture.h"
#include "roomcast/scene_flow/room_flow.h"

namespace roomcast::render {
namespace {

using namespace std::chrono_literals;

const CameraIntrinsics kMovingBoardLens = pinhole(96, 64, 90);
const RigidTransform kMovingBoardPose =
    world_from_optical_looking_at(Eigen::Vector3d(0, 1.5, 2), Eigen::Vector3d(0, 1.5, -4));
constexpr nanoseconds kPeriod = 50ms;
constexpr int kStep_px = 4, kRow = 32;

/// A green board of 24x24 pixels before a red wall.
SensorPictures board_from(int left) {
  SensorPictures pictures = wall(kMovingBoardLens, 2000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, left, 20, left + 24, 44, 1000);
  fill_box(pictures.color, left, 20, left + 24, 44, kGreen);
  return pictures;
}

class MovingBoard : public RoomTest, public ::testing::WithParamInterface<RenderMode> {
 protected:
  void SetUp() override {
    RoomTest::SetUp();
    if (HasFatalFailure()) return;
    for (int i = 0; i < 6; ++i) show(kFirst, wall(kMovingBoardLens, 2000, kRed), kPeriod);
    show(kFirst, board_from(28), kPeriod);
    show(kFirst, board_from(28 + kStep_px), kPeriod);
  }

  void show(SensorId id, const SensorPictures& pictures, nanoseconds after) {
    ASSERT_TRUE(room_->set_sensor(id, kMovingBoardLens, kMovingBoardPose).ok());
    time_ += after;
    const PictureMotion motion{time_, flow_.take(id, kMovingBoardLens, pictures.depth_mm, time_)};
    ASSERT_TRUE(room_->upload(id, pictures.depth_mm, pictures.color, pictures.seen, motion).ok());
  }

  /// The columns of the board in the middle of the picture.
  struct Extent {
    int left = 0, right = 0;
  };
  Extent board_at(std::optional<RoomTime> instant) {
    room_->set_instant(instant);
    const Picture picture = draw(eye_of(kMovingBoardLens, kMovingBoardPose), GetParam());
    Extent extent{kMovingBoardLens.width, 0};
    for (int x = 0; x < kMovingBoardLens.width; ++x) {
      const Rgb8 color = picture.color.at(x, kRow);
      if (color.g < 100 || color.r > 100) continue;
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
    }
    return extent;
  }

  RoomTime time_{};
  scene_flow::RoomFlow flow_;
};
INSTANTIATE_TEST_SUITE_P(Modes, MovingBoard,
                         ::testing::Values(RenderMode::kAdaptive, RenderMode::kBlend),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(MovingBoard, is_drawn_where_it_is_at_the_instant) {
  const Extent seen = board_at(time_);
  const Extent next = board_at(time_ + kPeriod), before = board_at(time_ - kPeriod);
  EXPECT_NEAR(seen.right - seen.left, 24, 6);
  EXPECT_NEAR(next.left - seen.left, kStep_px, 1);
  EXPECT_NEAR(next.right - seen.right, kStep_px, 1);
  EXPECT_NEAR(before.left - seen.left, -kStep_px, 1);
}

TEST_P(MovingBoard, is_not_moved_farther_than_anybody_knows) {
  EXPECT_EQ(board_at(time_ + kMaxAhead).right, board_at(time_ + 10s).right);
}

TEST_P(MovingBoard, of_one_sensor_stays_where_it_was_seen) {
  EXPECT_EQ(board_at(std::nullopt).left, board_at(time_).left);
}

TEST_P(MovingBoard, is_drawn_between_the_newest_pictures_of_two_sensors) {
  const Extent seen = board_at(time_);
  const RoomTime first = time_;
  show(kSecond, wall(kMovingBoardLens, 0, kRed), kPeriod);  // which sees nothing
  EXPECT_EQ(board_at(std::nullopt).left, board_at(first + kPeriod / 2).left);
  EXPECT_GT(board_at(std::nullopt).left, seen.left);
}

TEST_P(MovingBoard, is_not_drawn_elsewhere_for_a_sensor_that_is_far_behind) {
  show(kSecond, wall(kMovingBoardLens, 0, kRed), 0ms);
  time_ += 10 * kPeriod;
  show(kFirst, board_from(28 + kStep_px), 0ms);
  show(kFirst, board_from(28 + 2 * kStep_px), kPeriod);
  EXPECT_EQ(board_at(std::nullopt).left, board_at(time_).left);
}

TEST_P(MovingBoard, without_a_time_stays_where_it_was_seen) {
  const SensorPictures pictures = board_from(28 + 2 * kStep_px);
  ASSERT_TRUE(room_->upload(kFirst, pictures.depth_mm, pictures.color, pictures.seen).ok());
  EXPECT_EQ(board_at(time_ + kPeriod).left, board_at(std::nullopt).left);
}

TEST_P(MovingBoard, moves_on_while_its_picture_is_shown_again) {
  const Extent next = board_at(time_ + kPeriod);
  show(kFirst, board_from(28 + kStep_px), 0ms);
  EXPECT_EQ(board_at(time_ + kPeriod).left, next.left);
}

}  // namespace
}  // namespace roomcast::render
