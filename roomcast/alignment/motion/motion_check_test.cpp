// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/motion/motion_check.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/view/depth_noise.h"

namespace roomcast::alignment {
namespace {

constexpr double kOneDegree_rad = std::numbers::pi / 180;

const RigidTransform& fixed_pose() {
  static const RigidTransform pose = corner_pose(2, 1.5);
  return pose;
}

const MotionCheck& check_at_stand() {
  static const MotionCheck check(bundle_fixture({}, "s0", fixed_pose()));
  return check;
}

/// A noisy depth_at from `world_from_depth`.
DepthImage depth_at(const RoomFixture& room, const RigidTransform& world_from_depth,
                    unsigned seed = 1) {
  DepthImage depth_mm = depth_fixture(room, calibration_fixture().depth, world_from_depth);
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i) {
    std::uint16_t& reading = depth_mm.data()[i];
    const float noise_mm = 1000 * depth_sigma_m(0.001F * static_cast<float>(reading));
    reading = static_cast<std::uint16_t>(
        std::lround(static_cast<float>(reading) + noise_mm * normal(random)));
  }
  return depth_mm;
}

RigidTransform pushed_by(const Eigen::Vector3d& shift_m,
                         const Eigen::Vector3d& turn_rad = {0, 0, 0}) {
  RigidTransform push;
  push.translation_m = shift_m;
  if (turn_rad.norm() > 0) {
    push.rotation = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
  }
  return fixed_pose() * push;
}

TEST(MotionCheck, noise_is_no_motion) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const auto evidence = check_at_stand().compare(depth_at({}, fixed_pose(), seed).view());
    EXPECT_LT(evidence.shift_m, 0.007);
    EXPECT_LT(evidence.angle_rad, 0.15 * kOneDegree_rad);
    EXPECT_GT(evidence.agree_if_still, 0.95);
    EXPECT_LT(evidence.gain, 0.02);
  }
}

TEST(MotionCheck, two_centimetres_in_any_direction_are_measured) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double shift_m : {0.02, -0.02}) {
      const auto moved = pushed_by(shift_m * Eigen::Vector3d::Unit(axis));
      const auto evidence = check_at_stand().compare(depth_at({}, moved).view());
      EXPECT_NEAR(evidence.shift_m, 0.02, 0.005) << "axis " << axis;
      EXPECT_LT(evidence.angle_rad, 0.15 * kOneDegree_rad);
      EXPECT_GT(evidence.gain, 0.04) << axis;
    }
  }
}

TEST(MotionCheck, half_a_degree_about_any_axis_is_measured) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto moved = pushed_by({0, 0, 0}, 0.5 * kOneDegree_rad * Eigen::Vector3d::Unit(axis));
    const auto evidence = check_at_stand().compare(depth_at({}, moved).view());
    EXPECT_NEAR(evidence.angle_rad, 0.5 * kOneDegree_rad, 0.15 * kOneDegree_rad) << "axis " << axis;
    EXPECT_LT(evidence.shift_m, 0.007);
  }
}

TEST(MotionCheck, the_motion_is_that_of_the_sensor) {
  const auto moved = pushed_by({0.06, -0.03, 0.05}, {0, 3 * kOneDegree_rad, kOneDegree_rad});
  const auto evidence = check_at_stand().compare(depth_at({}, moved).view());
  const RigidTransform expected = moved.inverse() * fixed_pose();
  EXPECT_LT((evidence.now_from_then.translation_m - expected.translation_m).norm(), 0.005);
  EXPECT_GT(evidence.agree_if_moved, 0.9);
}

TEST(MotionCheck, somebody_close_hides_the_room_and_moves_nothing) {
  RoomFixture room;
  const Eigen::Vector3d before = fixed_pose() * Eigen::Vector3d(0.1, 0, 1.2);
  room.boxes.push_back(
      {before - Eigen::Vector3d(0.25, 1.3, 0.25), before + Eigen::Vector3d(0.25, 0.4, 0.25)});
  const auto evidence = check_at_stand().compare(depth_at(room, fixed_pose()).view());
  EXPECT_LT(evidence.comparable, 0.85);
  EXPECT_LT(evidence.shift_m, 0.005);
  EXPECT_GT(evidence.agree_if_still, 0.9);
}

TEST(MotionCheck, furniture_that_is_pushed_moves_no_sensor) {
  RoomFixture room;
  room.boxes[0].translate(Eigen::Vector3d(0.03, 0, 0.02));
  const auto evidence = check_at_stand().compare(depth_at(room, fixed_pose()).view());
  EXPECT_LT(evidence.shift_m, 0.006);
  EXPECT_LT(evidence.angle_rad, 0.15 * kOneDegree_rad);
}

TEST(MotionCheck, a_sensor_that_looks_elsewhere_misses_what_was_there) {
  const auto evidence =
      check_at_stand().compare(depth_at({}, pushed_by({0, 0, 0}, {0, -0.6, 0})).view());
  EXPECT_GT(evidence.gone, 0.3);
  EXPECT_LT(evidence.agree_if_still, 0.3);
}

TEST(MotionCheck, what_a_bare_wall_cannot_tell_counts_as_still) {
  const RoomFixture bare{.boxes = {}};
  const auto facing = world_from_optical_looking_at({0, 1.3, 1}, {0, 1.3, -2});
  auto bundle = bundle_fixture(bare, "s0", facing);
  const MotionCheck check(bundle);
  RigidTransform aside = facing;
  aside.translation_m.x() += 0.01;  // the floor and the side walls are out of view
  auto depth_mm = depth_at(bare, aside);
  EXPECT_LT(check.compare(depth_mm.view()).shift_m, 0.02);
}

TEST(MotionCheck, an_empty_picture_says_nothing) {
  const auto calibration = calibration_fixture();
  const DepthImage nothing(calibration.depth.width, calibration.depth.height);
  const auto evidence = check_at_stand().compare(nothing.view());
  EXPECT_EQ(evidence.comparable, 0);
  EXPECT_EQ(evidence.shift_m, 0);
}

}  // namespace
}  // namespace roomcast::alignment
