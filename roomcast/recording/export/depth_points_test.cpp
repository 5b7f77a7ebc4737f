// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/depth_points.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

const CameraIntrinsics kCamera = {
    .width = 40, .height = 30, .fx = 40, .fy = 40, .cx = 19.5, .cy = 14.5};

TEST(DepthPoints, a_wall_straight_ahead_has_normals_towards_the_camera) {
  DepthPoints points(kCamera);
  points.set(DepthImage(kCamera.width, kCamera.height, 2000));
  ASSERT_TRUE(points.has(20, 15));
  EXPECT_NEAR((points.normal(20, 15) - Eigen::Vector3f(0, 0, -1)).norm(), 0, 1e-5);
  EXPECT_NEAR(points.point_m(20, 15).x(), 0.5 / 40 * 2, 1e-5);
  EXPECT_NEAR(points.z_m(20, 15), 2, 1e-6);
}

TEST(DepthPoints, a_slanted_floor_has_its_own_normal) {
  // y = 1 below the camera: z = fy * 1 / (row - cy).
  DepthImage depth(kCamera.width, kCamera.height);
  for (int y = 20; y < kCamera.height; ++y)
    for (int x = 0; x < kCamera.width; ++x)
      depth.at(x, y) = static_cast<std::uint16_t>(40'000 / (y - 14.5));
  DepthPoints points(kCamera);
  points.set(depth);
  ASSERT_FALSE(points.has(20, 22)) << "too slanted to be told from a rim";
  CameraIntrinsics fine = {
      .width = 400, .height = 300, .fx = 400, .fy = 400, .cx = 199.5, .cy = 149.5};
  DepthImage fine_depth(fine.width, fine.height);
  for (int y = 200; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x)
      fine_depth.at(x, y) = static_cast<std::uint16_t>(400'000 / (y - 149.5));
  DepthPoints fine_points(fine);
  fine_points.set(fine_depth);
  ASSERT_TRUE(fine_points.has(200, 250));
  EXPECT_NEAR((fine_points.normal(200, 250) - Eigen::Vector3f(0, -1, 0)).norm(), 0, 0.05);
}

TEST(DepthPoints, rims_and_holes_are_no_surface) {
  DepthImage depth(kCamera.width, kCamera.height, 3000);
  for (int y = 0; y < kCamera.height; ++y)
    for (int x = 0; x < 20; ++x) depth.at(x, y) = 1500;
  depth.at(30, 15) = 0;
  DepthPoints points(kCamera);
  points.set(depth);
  EXPECT_TRUE(points.has(18, 15));
  EXPECT_FALSE(points.has(19, 15));
  EXPECT_FALSE(points.has(20, 15));
  EXPECT_FALSE(points.has(30, 15));
  EXPECT_FALSE(points.has(31, 15));
  EXPECT_FALSE(points.has(0, 0));
  EXPECT_TRUE(points.has(33, 15));
}

}  // namespace
}  // namespace roomcast::recording
