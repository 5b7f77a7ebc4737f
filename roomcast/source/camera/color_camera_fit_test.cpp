// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/color_camera_fit.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

SensorCalibration nominal() {
  SensorCalibration cameras;
  cameras.depth = {512, 424, 365, 365, 255.5, 211.5, 0.09, -0.27, 0.1};
  cameras.color = {960, 540, 530, 530, 479.5, 269.5};
  cameras.color_from_depth.translation_m.x() = -0.05;
  return cameras;
}

SensorCalibration real() {
  SensorCalibration cameras = nominal();
  cameras.color.fx = 537.5, cameras.color.fy = 536, cameras.color.cx = 483, cameras.color.cy = 262;
  cameras.color.k1 = 0.02, cameras.color.k2 = -0.03;
  cameras.color.p1 = 0.001, cameras.color.p2 = -0.0007;
  cameras.color_from_depth.translation_m.x() = -0.0521;
  const double c = std::cos(0.006), s = std::sin(0.006);
  cameras.color_from_depth.rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  return cameras;
}

std::vector<MappedPoint> mapped_by(const SensorCalibration& cameras) {
  std::vector<MappedPoint> points;
  for (int y = 10; y < cameras.depth.height; y += 20) {
    for (int x = 10; x < cameras.depth.width; x += 20) {
      for (const double z_m : {0.7, 1.5, 4.0}) {
        const Eigen::Vector3d point = *unproject(cameras.depth, Eigen::Vector2d(x, y), z_m);
        points.push_back({point, *project(cameras.color, cameras.color_from_depth * point)});
      }
    }
  }
  return points;
}

TEST(ColorCameraFit, finds_the_camera_that_the_mapping_was_made_with) {
  const auto found = fit_color_camera(nominal(), mapped_by(real()));
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_NEAR(found->color.fx, real().color.fx, 1e-3);
  EXPECT_NEAR(found->color.p2, real().color.p2, 1e-6);
  EXPECT_NEAR(found->color_from_depth.translation_m.x(), -0.0521, 1e-6);
}

TEST(ColorCameraFit, a_mapping_of_no_camera_is_refused) {
  auto points = mapped_by(real());
  for (std::size_t i = 0; i < points.size(); i += 4) points[i].seen_px = {100, 100};
  EXPECT_FALSE(fit_color_camera(nominal(), points).ok());
  EXPECT_FALSE(fit_color_camera(nominal(), {}).ok());
}

TEST(Mirrored, cameras_put_a_flipped_point_on_the_flipped_pixel) {
  const SensorCalibration cameras = real(), flipped = mirrored(cameras);
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.3, 0.2, 1), Eigen::Vector3d(-1, 0.5, 2)}) {
    const Eigen::Vector3d other(-point.x(), point.y(), point.z());
    const auto pixel = *project(cameras.color, cameras.color_from_depth * point);
    const auto pixel_flipped = *project(flipped.color, flipped.color_from_depth * other);
    EXPECT_NEAR(pixel_flipped.x(), cameras.color.width - 1 - pixel.x(), 1e-9);
    EXPECT_NEAR(pixel_flipped.y(), pixel.y(), 1e-9);
  }
}

}  // namespace
}  // namespace roomcast::source
