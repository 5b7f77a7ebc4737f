// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/depth_surface.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/view/floor.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kPose = corner_pose(2, 1.5);

DepthSurface corner_surface() {
  const SensorCalibration calibration = calibration_fixture();
  return depth_surface(depth_fixture({}, calibration.depth, kPose), calibration.depth);
}

TEST(DepthSurface, samples_lie_on_the_rooms_surfaces_with_normals_towards_the_camera) {
  const DepthSurface surface = corner_surface();
  ASSERT_GT(surface.samples.size(), 1000u);
  for (const SurfacePoint& sample : surface.samples) {
    const Eigen::Vector3d at = kPose * sample.point_m.cast<double>();
    const double again = cast_ray({}, kPose.translation_m, at - kPose.translation_m);
    EXPECT_NEAR(again, 1, 0.01);
    EXPECT_LT(sample.normal.dot(sample.point_m), 0);
    EXPECT_NEAR(sample.normal.norm(), 1, 1e-4);
  }
}

TEST(DepthSurface, normals_are_those_of_walls_and_boxes) {
  std::size_t along_an_axis = 0;
  const DepthSurface surface = corner_surface();
  for (const SurfacePoint& sample : surface.samples) {
    const Eigen::Vector3d normal = kPose.rotation * sample.normal.cast<double>();
    along_an_axis += normal.cwiseAbs().maxCoeff() > 0.98;
  }
  EXPECT_GT(along_an_axis, surface.samples.size() * 9 / 10);
}

TEST(DepthSurface, leaves_out_points_at_depth_edges) {
  DepthImage step(200, 160, 2000);
  for (int y = 0; y < 160; ++y) {
    for (int x = 100; x < 200; ++x) step.at(x, y) = 3000;
  }
  const DepthSurface surface = depth_surface(step, calibration_fixture().depth);
  EXPECT_EQ(surface.at.at(101, 80).normal.norm(), 0);
  EXPECT_NEAR(surface.at.at(90, 80).normal.norm(), 1, 1e-4);
}

TEST(DepthSurface, of_nothing_is_empty) {
  EXPECT_TRUE(depth_surface(DepthImage(200, 160), calibration_fixture().depth).samples.empty());
}

TEST(Planes, finds_floor_and_walls) {
  const DepthSurface surface = corner_surface();
  const auto planes = find_planes(surface.samples);
  ASSERT_GE(planes.size(), 3u);
  const auto floor = find_floor(planes, surface.samples, std::nullopt);
  ASSERT_TRUE(floor.has_value());
  const Eigen::Vector3d up = kPose.rotation.transpose() * Eigen::Vector3d::UnitY();
  EXPECT_GT(floor->normal.cast<double>().dot(up), std::cos(0.2 * M_PI / 180));
  EXPECT_NEAR(floor->offset_m, kPose.translation_m.y(), 0.005);
}

TEST(Planes, are_the_same_every_time) {
  const DepthSurface surface = corner_surface();
  const auto one = find_planes(surface.samples), other = find_planes(surface.samples);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].normal, other[i].normal);
}

TEST(Planes, of_no_samples_are_none) {
  EXPECT_TRUE(find_planes({}).empty());
}

TEST(Floor, is_not_a_table_that_stands_on_something_lower) {
  const DepthSurface surface = corner_surface();
  const RigidTransform depth_from_world = kPose.inverse();
  Plane table;
  table.normal = (depth_from_world.rotation * Eigen::Vector3d::UnitY()).cast<float>();
  table.offset_m = static_cast<float>(kPose.translation_m.y() - 0.7);
  table.points_m.assign(100'000, Eigen::Vector3f::Zero());
  EXPECT_FALSE(find_floor(std::vector{table}, surface.samples, std::nullopt).has_value());
}

TEST(Floor, is_not_a_wall_and_heeds_gravity) {
  const DepthSurface surface = corner_surface();
  const auto planes = find_planes(surface.samples);
  const Eigen::Vector3d sideways = kPose.rotation.transpose() * Eigen::Vector3d::UnitX();
  const auto floor = find_floor(planes, surface.samples, sideways);
  const double along = floor ? floor->normal.cast<double>().dot(sideways) : 1;
  EXPECT_GT(along, 0.97);
}

}  // namespace
}  // namespace roomcast::alignment
