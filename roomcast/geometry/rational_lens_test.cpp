// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rational_lens.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

/// A depth camera like that of an Azure Kinect in its mode NFOV unbinned.
RationalLens azure_depth() {
  RationalLens lens;
  lens.camera = {640, 576, 505, 505, 333, 349, 0.55, -0.021, -0.0027, 2e-05, -7e-05};
  lens.k4 = 0.89, lens.k5 = 0.086, lens.k6 = -0.014;
  return lens;
}

double largest_difference_px(const RationalLens& lens, const CameraIntrinsics& camera,
                             double radius) {
  double largest = 0;
  for (double r = 0.01; r < radius; r += 0.01) {
    for (double angle = 0; angle < 6.28; angle += 0.1) {
      const Eigen::Vector2d xy(r * std::cos(angle), r * std::sin(angle));
      const Eigen::Vector2d exact = distort(lens, xy), converted = distort(camera, xy);
      largest =
          std::max(largest, std::hypot(lens.camera.fx * exact.x() - camera.fx * converted.x(),
                                       lens.camera.fy * exact.y() - camera.fy * converted.y()));
    }
  }
  return largest;
}

TEST(RationalLens, is_converted_to_a_tenth_of_a_pixel_where_an_azure_kinect_sees_depth) {
  const auto converted = polynomial_lens(azure_depth(), 1.01);
  ASSERT_TRUE(converted.ok()) << converted.error().message;
  const double error = largest_difference_px(azure_depth(), converted->camera, 1.0);
  EXPECT_LT(error, 0.1);
  EXPECT_NEAR(error, converted->largest_error_px, 0.02);
}

TEST(RationalLens, a_point_projects_to_the_same_pixel) {
  const RationalLens lens = azure_depth();
  const auto converted = polynomial_lens(lens, 1.01);
  const Eigen::Vector3d point(0.6, -0.5, 1.1);
  const Eigen::Vector2d exact = distort(lens, point.head<2>() / point.z());
  const auto pixel = project(converted->camera, point);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), lens.camera.fx * exact.x() + lens.camera.cx, 0.1);
  EXPECT_NEAR(pixel->y(), lens.camera.fy * exact.y() + lens.camera.cy, 0.1);
}

TEST(RationalLens, without_a_denominator_it_is_kept_bit_for_bit) {
  RationalLens lens = azure_depth();
  lens.k4 = lens.k5 = lens.k6 = 0;
  const auto converted = polynomial_lens(lens, 1);
  ASSERT_TRUE(converted.ok());
  EXPECT_EQ(converted->camera, lens.camera);
  EXPECT_EQ(converted->largest_error_px, 0);
}

TEST(RationalLens, the_stated_error_is_the_real_one_for_a_wide_lens) {
  RationalLens lens = azure_depth();
  lens.camera.width = lens.camera.height = 1024;
  lens.camera.cx = lens.camera.cy = 520;
  const auto converted = polynomial_lens(lens, 1.74);
  ASSERT_TRUE(converted.ok());
  EXPECT_NEAR(largest_difference_px(lens, converted->camera, 1.73), converted->largest_error_px,
              0.1);
}

TEST(RationalLens, what_is_no_lens_is_refused) {
  RationalLens lens = azure_depth();
  lens.k4 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(polynomial_lens(lens, 1).ok());
  lens = azure_depth();
  lens.k4 = 40;  // the distorted radius shrinks with the radius
  EXPECT_FALSE(polynomial_lens(lens, 1).ok());
  lens.k4 = -40;  // the denominator has a zero
  EXPECT_FALSE(polynomial_lens(lens, 1).ok());
  lens = azure_depth();
  lens.camera.fx = 0;
  EXPECT_FALSE(polynomial_lens(lens, 1).ok());
  EXPECT_FALSE(polynomial_lens(azure_depth(), 0).ok());
}

}  // namespace
}  // namespace roomcast
