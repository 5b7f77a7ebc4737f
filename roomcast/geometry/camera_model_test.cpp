// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/camera_model.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Kinect v2 depth lens; depth and colour lenses of a Kinect-v2-like sensor; Kinect v1 depth (no
// distortion).
const CameraIntrinsics kKinectV2Depth{512,    424,     364.478, 364.478, 252.95, 205.88,
                                      0.0984, -0.2811, 0.0952,  0,       0};
const CameraIntrinsics kHouseDepth{
    512,          424,          364.600832,  364.654998,     256.013927,    206.672856,
    0.0868202702, -0.260639656, 0.100335667, -0.00018630048, 6.43596053e-05};
const CameraIntrinsics kHouseColor{
    1920,         1080,          1057.693483,   1058.527978,     958.097278,     542.175337,
    0.0171648743, -0.0300485637, 0.00112773132, -0.000324284792, -0.000433884931};
const CameraIntrinsics kKinectV1Depth{640, 480, 585, 585, 320, 240, 0, 0, 0, 0, 0};

class EveryCamera : public testing::TestWithParam<CameraIntrinsics> {};

TEST_P(EveryCamera, project_undoes_unproject_at_every_pixel) {
  const CameraIntrinsics& camera = GetParam();
  double worst_px = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const auto point = unproject(camera, {u, v}, 2.5);
      ASSERT_TRUE(point) << u << ',' << v;
      const auto pixel = project(camera, *point);
      ASSERT_TRUE(pixel) << u << ',' << v;
      worst_px = std::max(worst_px, (*pixel - Vector2d(u, v)).norm());
    }
  }
  EXPECT_LT(worst_px, 1e-6);
}

TEST_P(EveryCamera, the_ray_table_holds_the_ray_of_every_pixel) {
  const CameraIntrinsics& camera = GetParam();
  const auto rays = ray_table(camera);
  ASSERT_EQ(rays.width(), camera.width);
  ASSERT_EQ(rays.height(), camera.height);
  for (int v = 0; v < camera.height; v += 7) {
    for (int u = 0; u < camera.width; u += 5) {
      const auto point = unproject(camera, {u, v}, 1.0);
      ASSERT_TRUE(point);
      EXPECT_LT((rays.at(u, v).cast<double>() - point->head<2>()).norm(), 1e-6) << u << ',' << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cameras, EveryCamera,
                         testing::Values(kKinectV2Depth, kHouseDepth, kHouseColor, kKinectV1Depth));

TEST(Distort, agrees_with_values_worked_out_by_hand) {
  CameraIntrinsics camera{640, 480, 500, 500, 320, 240, 0.1, -0.2, 0.05, 0.01, -0.02};
  // x = 0.5, y = -0.25: r2 = 0.3125; radial = 1 + 0.03125 - 0.01953125 + 0.00152587890625
  // = 1.01324462890625 x' = 0.506622314453125 + 2*0.01*(-0.125) + (-0.02)*(0.3125 + 0.5)   =
  // 0.487872314453125 y' = -0.2533111572265625 + 0.01*(0.3125 + 0.125) + 2*(-0.02)*(-0.125) =
  // -0.2439361572265625
  const Vector2d distorted = distort(camera, {0.5, -0.25});
  EXPECT_NEAR(distorted.x(), 0.487872314453125, 1e-15);
  EXPECT_NEAR(distorted.y(), -0.2439361572265625, 1e-15);
}

TEST(Project, agrees_with_a_value_worked_out_by_hand) {
  CameraIntrinsics camera{640, 480, 500, 400, 320, 240};
  const auto pixel = project(camera, {1, -0.5, 2});
  ASSERT_TRUE(pixel);
  EXPECT_DOUBLE_EQ(pixel->x(), 570);
  EXPECT_DOUBLE_EQ(pixel->y(), 140);
}

TEST(Project, gives_nothing_behind_the_camera) {
  EXPECT_FALSE(project(kKinectV1Depth, {0, 0, 0}));
  EXPECT_FALSE(project(kKinectV1Depth, {0, 0, -1}));
  EXPECT_FALSE(project(kKinectV1Depth, {0, 0, std::nan("")}));
}

// With k1 = -0.3 alone, r (1 - 0.3 r^2) grows up to r^2 = 1 / 0.9 and comes back to the axis at r^2
// = 1 / 0.3.
const CameraIntrinsics kFolding{640, 480, 300, 300, 320, 240, -0.3, 0, 0, 0, 0};

TEST(Project, gives_nothing_where_the_lens_model_folds_over) {
  EXPECT_TRUE(project(kFolding, {std::sqrt(1.1), 0, 1}));
  EXPECT_FALSE(project(kFolding, {std::sqrt(1.12), 0, 1}));
  EXPECT_FALSE(project(kFolding, {std::sqrt(1 / 0.3), 0, 1}));  // not the principal point
}

TEST(Project, gives_nothing_past_a_fold_even_where_the_model_grows_again) {
  CameraIntrinsics camera = kKinectV1Depth;
  camera.k2 = -0.9;  // slope 1 - 4.5 x^2 + 2.8 x^3 with x = r^2: negative from 0.53 to 1.45
  camera.k3 = 0.4;
  EXPECT_TRUE(project(camera, {std::sqrt(0.5), 0, 1}));
  EXPECT_FALSE(project(camera, {1, 0, 1}));
  EXPECT_FALSE(project(camera, {std::sqrt(2.0), 0, 1}));
}

TEST(Undistort, gives_nothing_beyond_the_largest_distorted_radius) {
  const double fold = std::sqrt(1 / 0.9);
  const double largest = fold * (1 - 0.3 * fold * fold);
  EXPECT_TRUE(undistort(kFolding, {0.999 * largest, 0}));
  EXPECT_FALSE(undistort(kFolding, {1.001 * largest, 0}));
}

TEST(RayTable, marks_pixels_that_the_lens_model_cannot_reach) {
  const auto rays = ray_table(kFolding);
  EXPECT_TRUE(std::isnan(rays.at(0, 0).x()));
  EXPECT_FALSE(std::isnan(rays.at(320, 240).x()));
}

TEST(CameraIntrinsics, check_accepts_real_cameras) {
  EXPECT_TRUE(kKinectV2Depth.check().ok());
  EXPECT_TRUE(kHouseColor.check().ok());
}

TEST(CameraIntrinsics, check_names_the_offending_field) {
  const auto refusal_of = [](auto change) {
    CameraIntrinsics camera = kKinectV2Depth;
    change(camera);
    const Status status = camera.check();
    return status.ok() ? std::string() : status.error().message;
  };
  using C = CameraIntrinsics;
  EXPECT_NE(refusal_of([](C& c) { c.width = 0; }).find("width"), std::string::npos);
  EXPECT_NE(refusal_of([](C& c) { c.height = kMaxImageSide + 1; }).find("height"),
            std::string::npos);
  EXPECT_NE(refusal_of([](C& c) { c.fx = 0; }).find("fx"), std::string::npos);
  EXPECT_NE(refusal_of([](C& c) { c.fy = -1; }).find("fy"), std::string::npos);
  EXPECT_NE(refusal_of([](C& c) { c.k2 = std::nan(""); }).find("k2"), std::string::npos);
  EXPECT_NE(refusal_of([](C& c) { c.cx = std::numeric_limits<double>::infinity(); }).find("cx"),
            std::string::npos);
}

TEST(CameraModel, widest_radius_holds_every_ray_of_the_picture_and_little_more) {
  CameraIntrinsics camera;
  camera.width = 512;
  camera.height = 424;
  camera.fx = camera.fy = 365;
  camera.cx = 255.5;
  camera.cy = 211.5;
  const double corner = (255.5 * 255.5 + 211.5 * 211.5) / (365.0 * 365.0);
  EXPECT_GT(widest_radius_squared(camera), corner);
  EXPECT_LT(widest_radius_squared(camera), 1.02 * corner);
}

}  // namespace
}  // namespace roomcast
