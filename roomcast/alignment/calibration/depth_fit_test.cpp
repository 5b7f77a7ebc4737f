// SPDX-License-Identifier: Apache-2.0
// Depth pictures of boards at known poses, exact but for readings in whole millimetres.
#include "roomcast/alignment/calibration/depth_fit.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/calibration/views_fixture.h"

namespace roomcast::alignment::calibration {
namespace {

constexpr int kDepthViews = 12;
const DepthModel kTrueModel = {{(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(-0.015, Eigen::Vector3d::UnitY()))
                                    .toRotationMatrix(),
                                {-0.03, 0.004, -0.003}},
                               1.01,
                               -0.008};

SensorCalibration nominal_cameras() {
  SensorCalibration cameras;
  cameras.depth = cameras.color = {160, 120, 145, 145, 79.5, 59.5};
  cameras.color_from_depth.translation_m.x() = -0.025;
  return cameras;
}

/// What the depth camera reads of the board's plane.
DepthImage depth_of_board(const RigidTransform& color_from_board, const DepthModel& model) {
  const RigidTransform depth_from_board = model.color_from_depth.inverse() * color_from_board;
  const Eigen::Vector3d normal = depth_from_board.rotation.col(2);
  const auto rays = ray_table(nominal_cameras().depth);
  DepthImage depth_mm(160, 120);
  for (int y = 0; y < depth_mm.height(); ++y) {
    for (int x = 0; x < depth_mm.width(); ++x) {
      const Eigen::Vector3d ray = rays.at(x, y).cast<double>().homogeneous();
      const double z_m = normal.dot(depth_from_board.translation_m) / normal.dot(ray);
      const double reading_mm = 1000 * (z_m - model.bias_m) / model.scale;
      if (reading_mm > 0 && reading_mm < 5000)
        depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(reading_mm));
    }
  }
  return depth_mm;
}

/// Views of boards held about, and their depth pictures.
struct DepthViews {
  std::vector<DepthImage> pictures;
  std::vector<BoardDepth> views;

  explicit DepthViews(const DepthModel& model, int count = kDepthViews) {
    const auto poses = held_about({}, count);
    for (const RigidTransform& pose : poses) pictures.push_back(depth_of_board(pose, model));
    for (std::size_t i = 0; i < poses.size(); ++i) views.push_back({&pictures[i], poses[i]});
  }
};

TEST(DepthFit, finds_pose_scale_and_bias) {
  const DepthViews seen(kTrueModel);
  const auto fit = fit_depth({}, seen.views, nominal_cameras());
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  const DepthModel& found = fit->model;
  // Thousands of readings, each rounded by 0.3 mm: a tenth of the noise for which sigmas are given.
  EXPECT_LT(
      1000 *
          (found.color_from_depth.translation_m - kTrueModel.color_from_depth.translation_m).norm(),
      fit->translation_sigma_mm);
  EXPECT_LT((found.color_from_depth.rotation - kTrueModel.color_from_depth.rotation).norm(), 0.001);
  EXPECT_LT(1000 * std::abs(found.bias_m - kTrueModel.bias_m), fit->bias_sigma_mm);
  EXPECT_NEAR(found.scale, kTrueModel.scale, 0.002);
}

TEST(DepthFit, reports_each_view_before_and_after) {
  const DepthViews seen(kTrueModel);
  const auto fit = fit_depth({}, seen.views, nominal_cameras());
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  ASSERT_EQ(fit->views.size(), std::size_t(kDepthViews));
  for (const PlaneError& view : fit->views) {
    EXPECT_GE(view.readings, 200u);
    EXPECT_NEAR(view.distance_m, 0.85, 0.4);
    EXPECT_LT(std::abs(view.mean_after_mm), 0.3);
    EXPECT_LT(view.rms_after_mm, 0.6);  // rounding: 0.29
  }
}

TEST(DepthFit, readings_behind_the_board_are_positive) {
  DepthModel too_far;  // true z = reading - 1 cm
  too_far.color_from_depth = nominal_cameras().color_from_depth;
  too_far.bias_m = -0.01;
  const DepthViews seen(too_far);
  const auto fit = fit_depth({}, seen.views, nominal_cameras());
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  // Along the normal, of boards tilted by up to 0.75 rad.
  for (const PlaneError& view : fit->views) {
    EXPECT_GT(view.mean_before_mm, 6);
    EXPECT_LT(view.mean_before_mm, 10.5);
  }
}

TEST(DepthFit, of_registered_colour_fits_scale_and_bias_only) {
  DepthModel registered;
  registered.scale = 0.99;
  registered.bias_m = 0.005;
  const DepthViews seen(registered);
  SensorCalibration cameras = nominal_cameras();
  cameras.color_is_registered = true;
  const auto fit = fit_depth({}, seen.views, cameras);
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  EXPECT_LT(fit->model.color_from_depth.translation_m.norm(), 1e-6);
  EXPECT_LT((fit->model.color_from_depth.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-6);
  EXPECT_NEAR(fit->model.scale, 0.99, 0.001);
  EXPECT_NEAR(fit->model.bias_m, 0.005, 0.001);
}

TEST(DepthFit, takes_six_views_with_readings_on_the_board) {
  DepthViews seen(kTrueModel, 7);
  seen.pictures[3] = DepthImage(160, 120);  // no readings
  const auto fit = fit_depth({}, seen.views, nominal_cameras());
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  EXPECT_EQ(fit->views[3].readings, 0u);
  EXPECT_GT(fit->views[4].readings, 0u);
  seen.pictures[4] = DepthImage(160, 120);
  EXPECT_EQ(fit_depth({}, seen.views, nominal_cameras()).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(fit_depth({}, {}, nominal_cameras()).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
