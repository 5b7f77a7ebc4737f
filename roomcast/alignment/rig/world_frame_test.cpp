// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/world_frame.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

constexpr double kSinglePrecision = 1e-5;

/// The floor seen by a sensor `height_m` above it that looks down by `down_rad`.
Plane floor_below(double height_m, double down_rad) {
  const Eigen::Vector3d up(0, -std::cos(down_rad), -std::sin(down_rad));
  return {up.cast<float>(), static_cast<float>(height_m), {}};
}

TEST(WorldFrame, has_the_floor_at_zero_and_the_origin_sensor_above_its_middle) {
  const double down_rad = 0.5, height_m = 1.7;
  const WorldFrame frame = world_frame(std::vector{floor_below(height_m, down_rad)});
  EXPECT_TRUE(frame.has_floor);
  const RigidTransform& world = frame.world_from_origin;
  EXPECT_LT((world.translation_m - Eigen::Vector3d(0, height_m, 0)).norm(), kSinglePrecision);
  // It looks along -z and down; its optical axis meets the floor at height / tan.
  const Eigen::Vector3d seen = world * Eigen::Vector3d(0, 0, height_m / std::sin(down_rad));
  EXPECT_LT((seen - Eigen::Vector3d(0, 0, -height_m / std::tan(down_rad))).norm(),
            kSinglePrecision);
  EXPECT_NEAR(world.rotation.determinant(), 1, kSinglePrecision);
  EXPECT_GT(world.rotation(0, 0), 0.999);  // right in the picture is right in the world
}

TEST(WorldFrame, without_a_floor_up_is_up_in_the_origin_sensors_picture) {
  const WorldFrame frame = world_frame({});
  EXPECT_FALSE(frame.has_floor);
  EXPECT_TRUE(frame.world_from_origin.translation_m.isZero());
  const Eigen::Matrix3d expected = Eigen::Vector3d(1, -1, -1).asDiagonal();
  EXPECT_EQ(frame.world_from_origin.rotation, expected);
}

TEST(WorldFrame, a_table_that_one_sensor_takes_for_its_floor_is_outvoted) {
  const Plane floor = floor_below(1.6, 0.4), table = floor_below(0.9, 0.4);
  const WorldFrame frame = world_frame(std::vector{table, floor, floor});
  EXPECT_NEAR(frame.world_from_origin.translation_m.y(), 1.6, kSinglePrecision);
}

TEST(WorldFrame, of_a_table_and_a_floor_it_is_the_lower) {
  const Plane floor = floor_below(1.6, 0.4), table = floor_below(0.9, 0.4);
  for (const auto& floors : {std::vector{table, floor}, std::vector{floor, table}})
    EXPECT_NEAR(world_frame(floors).world_from_origin.translation_m.y(), 1.6, kSinglePrecision);
}

TEST(WorldFrame, floors_tilted_against_each_other_do_not_agree) {
  // Six degrees: more than the five within which floors agree.
  const double tilt_rad = 6 * M_PI / 180;
  const Plane level = floor_below(1.6, 0.4), tilted = floor_below(1.6, 0.4 + tilt_rad);
  const WorldFrame frame = world_frame(std::vector{tilted, level, level});
  const Eigen::Vector3d up = level.normal.cast<double>();
  EXPECT_LT((frame.world_from_origin.rotation * up - Eigen::Vector3d::UnitY()).norm(),
            kSinglePrecision);
}

TEST(WorldFrame, takes_the_median_height_and_the_mean_normal) {
  const double tilt_rad = 0.02;
  const WorldFrame frame =
      world_frame(std::vector{floor_below(1.58, 0.4 - tilt_rad), floor_below(1.50, 0.4),
                              floor_below(1.51, 0.4 + tilt_rad)});
  EXPECT_NEAR(frame.world_from_origin.translation_m.y(), 1.51, kSinglePrecision);
  const Eigen::Vector3d mean = floor_below(0, 0.4).normal.cast<double>();
  EXPECT_LT((frame.world_from_origin.rotation * mean - Eigen::Vector3d::UnitY()).norm(),
            kSinglePrecision);
}

TEST(WorldFrame, a_sensor_that_looks_straight_down_has_the_top_of_its_picture_towards_minus_z) {
  const WorldFrame frame = world_frame(std::vector{Plane{{0, 0, -1}, 2.4F, {}}});
  const Eigen::Vector3d top = frame.world_from_origin.rotation * -Eigen::Vector3d::UnitY();
  EXPECT_LT((top + Eigen::Vector3d::UnitZ()).norm(), kSinglePrecision);
  EXPECT_NEAR(frame.world_from_origin.rotation.determinant(), 1, kSinglePrecision);
}

TEST(TransformedPlane, has_the_same_height_below_the_same_point) {
  const Plane in_b = floor_below(1.3, 0.6);
  RigidTransform a_from_b;
  a_from_b.rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  a_from_b.translation_m = {0.4, -0.8, 2.5};
  const Plane in_a = transformed(a_from_b, in_b);
  const Eigen::Vector3d point_m(0.7, -0.2, 1.9);  // in b
  EXPECT_NEAR(in_a.height_m((a_from_b * point_m).cast<float>()),
              in_b.height_m(point_m.cast<float>()), kSinglePrecision);
  EXPECT_LT((in_a.normal.cast<double>() - a_from_b.rotation * in_b.normal.cast<double>()).norm(),
            kSinglePrecision);
}

}  // namespace
}  // namespace roomcast::alignment
