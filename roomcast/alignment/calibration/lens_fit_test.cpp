// SPDX-License-Identifier: Apache-2.0
// Corners of a board projected by a known camera.
#include "roomcast/alignment/calibration/lens_fit.h"

#include <utility>

#include <gtest/gtest.h>

#include "roomcast/alignment/calibration/views_fixture.h"

namespace roomcast::alignment::calibration {
namespace {

constexpr int kLensViews = 10;
const CameraIntrinsics kTrueLens = {640, 480, 527.3, 525.1, 324.2, 243.9, 0.09, -0.21, 0, 0.0008};
const CameraIntrinsics kNominalLens = {640, 480, 550, 550, 319.5, 239.5};

std::vector<std::vector<SeenCorner>> projected_corners(const std::vector<RigidTransform>& poses) {
  const CharucoBoard board;
  std::vector<std::vector<SeenCorner>> views;
  for (const RigidTransform& pose : poses) {
    auto& view = views.emplace_back();
    for (int i = 0; i < board.corner_count(); ++i) {
      const Eigen::Vector2d at = board.corner_m(i);
      view.push_back({i, *project(kTrueLens, pose * Eigen::Vector3d(at.x(), at.y(), 0))});
    }
  }
  return views;
}

TEST(LensFit, finds_the_lens_and_the_boards_poses) {
  const auto poses = held_about({}, kLensViews);
  const auto fit = fit_lens({}, projected_corners(poses), kNominalLens, false);
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  // Corners are exact to single precision, 3e-5 pixels: a thousand times better than is asked here.
  EXPECT_NEAR(fit->camera.fx, kTrueLens.fx, 0.05);
  EXPECT_NEAR(fit->camera.fy, kTrueLens.fy, 0.05);
  EXPECT_NEAR(fit->camera.cx, kTrueLens.cx, 0.05);
  EXPECT_NEAR(fit->camera.cy, kTrueLens.cy, 0.05);
  EXPECT_NEAR(fit->camera.k1, kTrueLens.k1, 0.001);
  EXPECT_NEAR(fit->camera.k2, kTrueLens.k2, 0.01);
  EXPECT_NEAR(fit->camera.p1, kTrueLens.p1, 1e-4);
  EXPECT_NEAR(fit->camera.p2, 0, 1e-4);
  EXPECT_EQ(fit->camera.k3, 0);
  EXPECT_LT(fit->rms_px, 0.01);
  EXPECT_EQ(fit->errors.size(), std::size_t(24 * kLensViews));
  ASSERT_EQ(fit->camera_from_board.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT((fit->camera_from_board[i].translation_m - poses[i].translation_m).norm(), 0.0002);
}

TEST(LensFit, keeps_a_lens_that_is_known_and_needs_one_view_for_it) {
  const auto poses = held_about({}, 1);
  const auto fit = fit_lens({}, projected_corners(poses), kTrueLens, true);
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  EXPECT_EQ(fit->camera, kTrueLens);
  EXPECT_LT((fit->camera_from_board[0].translation_m - poses[0].translation_m).norm(), 0.0002);
  EXPECT_LT((fit->camera_from_board[0].rotation - poses[0].rotation).norm(), 0.001);
}

TEST(LensFit, an_error_is_what_was_measured_minus_what_was_expected) {
  auto views = projected_corners(held_about({}, 1));
  views[0][10].pixel += Eigen::Vector2d(3, 0);
  const auto fit = fit_lens({}, views, kTrueLens, true);
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  // 23 of 24 corners hold the board: no more than some tenths follow the one.
  EXPECT_NEAR(fit->errors[10].error_px.x(), 3, 1);
  EXPECT_EQ(fit->errors[10].pixel, views[0][10].pixel);
  EXPECT_LT(std::abs(fit->errors[0].error_px.x()), 1);
}

TEST(LensFit, takes_six_views) {
  const auto code = [](int views, bool keep_lens) {
    const auto fit = fit_lens({}, projected_corners(held_about({}, views)), kTrueLens, keep_lens);
    return fit.ok() ? std::optional<ErrorCode>() : fit.error().code;
  };
  EXPECT_EQ(code(5, false), ErrorCode::kNotFound);
  EXPECT_EQ(code(6, false), std::nullopt);
  EXPECT_EQ(code(0, true), ErrorCode::kNotFound);
}

TEST(LensFit, refuses_corners_that_fit_no_flat_board) {
  auto views = projected_corners(held_about({}, kLensViews));
  for (auto& view : views) std::swap(view[0].pixel, view[23].pixel);
  for (const bool keep_lens : {false, true}) {
    const auto fit = fit_lens({}, views, kTrueLens, keep_lens);
    ASSERT_FALSE(fit.ok());
    EXPECT_EQ(fit.error().code, ErrorCode::kMalformed);
  }
}

}  // namespace
}  // namespace roomcast::alignment::calibration
