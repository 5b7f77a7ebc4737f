// SPDX-License-Identifier: Apache-2.0
#include "bench/redundancy/better_shown.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

constexpr CameraIntrinsics kLens{
    .width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 31.5, .cy = 23.5};

/// A sensor that looks along +z at a wall, from this far.
SensorDepth before_a_wall(const DepthImage& depth_mm, double wall_z_m) {
  RigidTransform pose;
  pose.translation_m = {0, 0, wall_z_m - 1e-3 * depth_mm.at(0, 0)};
  return {&kLens, pose, depth_mm.view()};
}

int shown(const MaskImage& mask) {
  return static_cast<int>(std::count(mask.data(), mask.data() + 64 * 48, 255));
}

TEST(BetterShown, the_nearer_sensor_shows_a_wall_better) {
  const DepthImage near_mm(64, 48, 1500), far_mm(64, 48, 3000);
  const std::vector<SensorDepth> sensors = {before_a_wall(near_mm, 3), before_a_wall(far_mm, 3)};
  EXPECT_EQ(shown(better_shown(sensors, 0)), 0);
  const int of_far = shown(better_shown(sensors, 1));
  EXPECT_GT(of_far, 700) << "the quarter of its picture that the other sees";
  EXPECT_LT(of_far, 800);
}

TEST(BetterShown, a_little_better_does_not_count) {
  const DepthImage near_mm(64, 48, 2900), far_mm(64, 48, 3000);
  const std::vector<SensorDepth> sensors = {before_a_wall(near_mm, 3), before_a_wall(far_mm, 3)};
  EXPECT_EQ(shown(better_shown(sensors, 1)), 0);
}

TEST(BetterShown, what_the_other_sees_in_front_is_another_surface) {
  const DepthImage near_mm(64, 48, 1500), far_mm(64, 48, 3000);
  SensorDepth near_sensor = before_a_wall(near_mm, 3);
  near_sensor.world_from_depth.translation_m.z() -= 0.5;
  EXPECT_EQ(shown(better_shown({near_sensor, before_a_wall(far_mm, 3)}, 1)), 0);
}

TEST(BetterShown, a_sensor_that_looks_from_behind_shows_the_other_side) {
  const DepthImage near_mm(64, 48, 1500), far_mm(64, 48, 3000);
  SensorDepth behind = before_a_wall(near_mm, 3);
  behind.world_from_depth.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  behind.world_from_depth.translation_m = {0, 0, 4.5};
  EXPECT_EQ(shown(better_shown({behind, before_a_wall(far_mm, 3)}, 1)), 0);
}

}  // namespace
}  // namespace roomcast::bench
