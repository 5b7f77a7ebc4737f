// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/kinect_calibration.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

/// The tables of a Kinect with known cameras, as libfreenect expands them.
struct Unfolded {
  std::vector<std::array<std::int32_t, 2>> pixels;
  std::vector<std::int32_t> shifts = std::vector<std::int32_t>(10'000, 0);

  explicit Unfolded(const SensorCalibration& truth) {
    SensorCalibration at_infinity = truth;
    at_infinity.color_from_depth.translation_m.setZero();
    for (int y = 0; y < kKinectHeight; ++y) {
      for (int x = 0; x < kKinectWidth; ++x) {
        const Eigen::Vector3d ray = *unproject(truth.depth, Eigen::Vector2d(x, y), 1);
        const auto seen = *project(truth.color, at_infinity.color_from_depth * ray);
        pixels.push_back({static_cast<std::int32_t>((seen.x() + 0.5) * 256),
                          static_cast<std::int32_t>(std::floor(seen.y() + 0.5))});
      }
    }
    for (std::size_t mm = 1; mm < shifts.size(); ++mm) {
      const double shift_px = truth.color.fx * truth.color_from_depth.translation_m.x() /
                              (0.001 * static_cast<double>(mm));
      shifts[mm] = static_cast<std::int32_t>(shift_px * 256);
    }
  }
  [[nodiscard]] KinectColorMap map() const { return {pixels, shifts}; }
};

SensorCalibration some_kinect() {
  SensorCalibration truth = typical_kinect({});
  truth.color.fx = 529.4, truth.color.fy = 528.1;
  truth.color.cx = 326.2, truth.color.cy = 233.8;
  truth.color.k1 = 0.03, truth.color.k2 = -0.05;
  const double roll = 0.004;
  truth.color_from_depth.rotation << std::cos(roll), -std::sin(roll), 0, std::sin(roll),
      std::cos(roll), 0, 0, 0, 1;
  truth.color_from_depth.translation_m = {-0.0241, 0, 0};
  return truth;
}

TEST(KinectCalibration, fitted_cameras_reproduce_the_tables) {
  const SensorCalibration truth = some_kinect();
  const auto found = kinect_calibration({}, Unfolded(truth).map());
  ASSERT_TRUE(found.ok()) << found.error().message;
  // The tables contain y in whole pixels.
  EXPECT_NEAR(found->color.fx, truth.color.fx, 0.3);
  EXPECT_NEAR(found->color.fy, truth.color.fy, 0.6);
  EXPECT_NEAR(found->color_from_depth.translation_m.x(), -0.0241, 0.0002);
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-0.8, 0.6, 2), Eigen::Vector3d(2, -1.5, 5)}) {
    const auto expected = *project(truth.color, truth.color_from_depth * point);
    const auto got = *project(found->color, found->color_from_depth * point);
    EXPECT_LT((expected - got).norm(), 0.4);
  }
}

TEST(KinectCalibration, tables_that_are_no_camera_are_refused) {
  Unfolded broken(some_kinect());
  for (std::size_t i = 0; i < broken.pixels.size(); i += 3) broken.pixels[i] = {51'200, 17};
  EXPECT_EQ(kinect_calibration({}, broken.map()).error().code, ErrorCode::kMalformed);
  std::vector<std::array<std::int32_t, 2>> zeros(kKinectWidth * kKinectHeight);
  EXPECT_FALSE(kinect_calibration({}, {zeros, broken.shifts}).ok());
  EXPECT_FALSE(kinect_calibration({}, {}).ok());
  const Unfolded good(some_kinect());
  EXPECT_FALSE(kinect_calibration({.distance_mm = 0}, good.map()).ok());
}

TEST(KinectCalibration, a_typical_kinect_has_its_colour_camera_to_the_side) {
  const SensorCalibration typical = typical_kinect({});
  EXPECT_TRUE(typical.depth.check().ok());
  EXPECT_DOUBLE_EQ(typical.color_from_depth.translation_m.x(), -0.025);
  EXPECT_FALSE(typical.color_is_registered);
}

}  // namespace
}  // namespace roomcast::source
