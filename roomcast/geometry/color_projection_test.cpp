// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/color_projection.h"

#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SensorCalibration kinect_v2_like() {
  SensorCalibration calibration;
  calibration.depth = {512, 424, 364.6, 364.65, 256.0, 206.7, 0.0868, -0.2606, 0.1003, -0.0002};
  calibration.color = {1920,   1080,    1065.9,  1066.4,  958.5,   545.5,
                       0.0179, -0.0332, -0.0009, 0.00014, -0.00005};
  calibration.color_from_depth.rotation =
      Eigen::AngleAxisd(0.006, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  calibration.color_from_depth.translation_m = Vector3d(-0.052, 0.0003, -0.0005);
  return calibration;
}

struct Row {
  explicit Row(std::size_t width) : u(width), v(width), z_m(width) {}
  std::vector<float> u, v, z_m;
  ProjectedRow out() { return {u.data(), v.data(), z_m.data()}; }
};

TEST(ColorProjection, agrees_with_the_camera_model_to_a_hundredth_of_a_pixel) {
  const SensorCalibration calibration = kinect_v2_like();
  const ColorProjection projection(calibration);
  Row row(512);
  int compared = 0;
  for (int y = 0; y < 424; y += 11) {
    std::vector<std::uint16_t> depth_mm(512);
    for (std::size_t x = 0; x < 512; ++x) depth_mm[x] = static_cast<std::uint16_t>(600 + 15 * x);
    projection.project_row(depth_mm.data(), y, row.out());
    for (std::size_t x = 0; x < 512; ++x) {
      if (!(row.z_m[x] > 0)) continue;
      const auto point = unproject(calibration.depth, Vector2d(double(x), y), 0.001 * depth_mm[x]);
      const Vector3d seen_by_color = calibration.color_from_depth * *point;
      const auto pixel = project(calibration.color, seen_by_color);
      ASSERT_TRUE(pixel);
      ASSERT_NEAR(row.u[x], pixel->x(), 0.01);
      ASSERT_NEAR(row.v[x], pixel->y(), 0.01);
      ASSERT_NEAR(row.z_m[x], seen_by_color.z(), 1e-5);
      ++compared;
    }
  }
  EXPECT_GT(compared, 512 * 30);
}

TEST(ColorProjection, pixels_outside_the_picture_or_without_depth_are_zero) {
  const ColorProjection projection(kinect_v2_like());
  const std::vector<std::uint16_t> depth_mm(512, 2000);
  Row row(512);
  projection.project_row(depth_mm.data(), 0, row.out());  // above the colour picture
  EXPECT_EQ(row.z_m, std::vector<float>(512, 0.0F));
  EXPECT_EQ(row.u, std::vector<float>(512, 0.0F));
  projection.project_row(std::vector<std::uint16_t>(512, 0).data(), 200, row.out());
  EXPECT_EQ(row.z_m, std::vector<float>(512, 0.0F));
}

TEST(ColorProjection, rays_far_outside_do_not_fold_back_into_the_picture) {
  SensorCalibration calibration;
  calibration.depth = {200, 200, 50, 50, 99.5, 99.5};  // 126 degrees field of view
  calibration.color = {400, 400, 300, 300, 199.5, 199.5, -0.3};
  const ColorProjection projection(calibration);
  const std::vector<std::uint16_t> depth_mm(200, 1000);
  Row row(200);
  projection.project_row(depth_mm.data(), 100, row.out());
  EXPECT_GT(row.z_m[100], 0);
  for (std::size_t x = 0; x < 10; ++x) EXPECT_EQ(row.z_m[x], 0) << x;  // x/z near -1.9
}

TEST(ColorProjection, spacing_is_the_ratio_of_the_focal_lengths) {
  SensorCalibration calibration;
  calibration.depth = {100, 80, 100, 100, 49.5, 39.5};
  calibration.color = {400, 300, 300, 300, 199.5, 149.5};
  const auto spacing = ColorProjection(calibration).spacing();
  EXPECT_NEAR(spacing.typical, 3, 0.01);
  EXPECT_NEAR(spacing.largest, 3, 0.01);
}

TEST(ColorProjection, spacing_of_cameras_that_see_nothing_in_common_is_one) {
  SensorCalibration calibration = kinect_v2_like();
  calibration.color_from_depth.rotation =
      Eigen::AngleAxisd(3.1, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_EQ(ColorProjection(calibration).spacing().largest, 1);
}

}  // namespace
}  // namespace roomcast
