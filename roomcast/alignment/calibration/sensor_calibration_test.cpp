// SPDX-License-Identifier: Apache-2.0
// Simulated board views with known cameras.
#include "roomcast/alignment/calibration/sensor_calibration.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/alignment/calibration/views_fixture.h"

namespace roomcast::alignment::calibration {
namespace {

constexpr int kViews = 20;

double degrees_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(a.transpose() * b).angle() * 180 / std::numbers::pi;
}

/// Computed once for all tests: it takes seconds.
class RenderedBoards : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    SensorFixture sensor(kinect_fixture(), board());
    CharucoFinder finder(board());
    for (const RigidTransform& pose : held_about(board(), kViews)) {
      source::CapturedFrame frame = sensor.see(pose);
      views().push_back({finder.find(frame.color), std::move(frame.depth_mm)});
      poses().push_back(pose);
    }
  }
  static void TearDownTestSuite() { views().clear(); }

  static CharucoBoard board() { return {}; }
  static std::vector<BoardView>& views() {
    static std::vector<BoardView> all;
    return all;
  }
  static std::vector<RigidTransform>& poses() {
    static std::vector<RigidTransform> all;
    return all;
  }
  /// Nominal values, as used for a camera without a stored calibration.
  static SensorCalibration start() {
    SensorCalibration nominal;
    nominal.depth = kinect_fixture().calibration.depth;
    nominal.color = {640, 480, 525, 525, 319.5, 239.5};
    nominal.color_from_depth.translation_m.x() = -0.025;
    return nominal;
  }
};

TEST_F(RenderedBoards, corners_are_found_to_a_tenth_of_a_pixel) {
  const CameraIntrinsics color = kinect_fixture().calibration.color;
  std::vector<double> errors;
  for (std::size_t i = 0; i < views().size(); ++i) {
    EXPECT_GE(views()[i].corners.size(), 15U) << i;
    for (const SeenCorner& seen : views()[i].corners) {
      const Eigen::Vector2d at = board().corner_m(seen.corner);
      errors.push_back(
          (seen.pixel - *project(color, poses()[i] * Eigen::Vector3d(at.x(), at.y(), 0))).norm());
    }
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.1);
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.3);
}

TEST_F(RenderedBoards, lens_pose_and_depth_are_found) {
  const io::RecordedCamera truth = kinect_fixture();
  const auto report = calibrate(board(), views(), start(), false);
  ASSERT_TRUE(report.ok()) << report.error().message;
  const SensorCalibration& found = report->camera.calibration;
  const SensorCalibration& real = truth.calibration;
  const double focal_error = std::max(std::abs(found.color.fx / real.color.fx - 1),
                                      std::abs(found.color.fy / real.color.fy - 1));
  const double shift_mm =
      1000 * (found.color_from_depth.translation_m - real.color_from_depth.translation_m).norm();
  const double turn_deg =
      degrees_between(found.color_from_depth.rotation, real.color_from_depth.rotation);
  // Scale and bias are checked together: the error of a reading counts, over the range of the
  // boards.
  double worst_depth_mm = 0;
  for (const double z : {0.5, 0.8, 1.2, 1.6}) {
    const double mm = 1000 * z;
    const double off = mm * report->camera.depth_scale_to_metre + report->camera.depth_bias_m -
                       mm * truth.depth_scale_to_metre - truth.depth_bias_m;
    worst_depth_mm = std::max(worst_depth_mm, 1000 * std::abs(off));
  }
  const double bias_mm = 1000 * std::abs(report->camera.depth_bias_m - truth.depth_bias_m);
  RecordProperty("focal_per_million", static_cast<int>(1e6 * focal_error));
  RecordProperty("shift_um", static_cast<int>(1000 * shift_mm));
  RecordProperty("turn_millidegrees", static_cast<int>(1000 * turn_deg));
  RecordProperty("depth_um", static_cast<int>(1000 * worst_depth_mm));
  RecordProperty("bias_um", static_cast<int>(1000 * bias_mm));
  EXPECT_LT(focal_error, 0.002);
  EXPECT_LT(shift_mm, 2);
  EXPECT_LT(turn_deg, 0.1);
  EXPECT_LT(bias_mm, 2);
  EXPECT_LT(worst_depth_mm, 2);
}

TEST_F(RenderedBoards, the_report_says_what_became_better) {
  const auto report = calibrate(board(), views(), start(), false);
  ASSERT_TRUE(report.ok());
  EXPECT_LT(report->lens.rms_px, 0.3);
  double before = 0, after = 0;
  for (const PlaneError& view : report->depth.views) {
    before += std::abs(view.mean_before_mm);
    after += std::abs(view.mean_after_mm);
  }
  EXPECT_LT(after, 0.3 * before);
  EXPECT_LT(report->depth.translation_sigma_mm, 2);
}

TEST_F(RenderedBoards, a_lens_that_is_known_is_kept) {
  SensorCalibration known = start();
  known.color = kinect_fixture().calibration.color;
  const auto report = calibrate(board(), views(), known, true);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->camera.calibration.color, known.color);
  const double shift_mm = 1000 * (report->camera.calibration.color_from_depth.translation_m -
                                  kinect_fixture().calibration.color_from_depth.translation_m)
                                     .norm();
  EXPECT_LT(shift_mm, 2);
}

TEST_F(RenderedBoards, too_few_views_or_no_depth_say_what_is_missing) {
  const std::vector<BoardView> few(views().begin(), views().begin() + 5);
  EXPECT_EQ(calibrate(board(), few, start(), false).error().code, ErrorCode::kNotFound);
  std::vector<BoardView> blind = views();
  for (BoardView& view : blind) view.depth_mm = DepthImage(640, 480);
  EXPECT_EQ(calibrate(board(), blind, start(), false).error().code, ErrorCode::kNotFound);
}

TEST_F(RenderedBoards, a_board_of_another_size_shows_in_the_depth_not_in_the_lens) {
  CharucoBoard larger = board();
  larger.square_m *= 1.02;
  const auto report = calibrate(larger, views(), start(), false);
  ASSERT_TRUE(report.ok());
  EXPECT_NEAR(report->camera.depth_scale_to_metre / kinect_fixture().depth_scale_to_metre, 1.02,
              0.004);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
