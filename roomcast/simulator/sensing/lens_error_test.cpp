// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/lens_error.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(LensError, is_within_its_limits_and_uses_most_of_them) {
  double widest_focal = 0, widest_centre = 0, mean_focal = 0;
  constexpr int kDraws = 400;
  for (std::uint32_t seed = 0; seed < kDraws; ++seed) {
    Random random(seed);
    const LensError error = draw_lens_error(random);
    EXPECT_LE(std::abs(error.focal), kMaxFocalError);
    EXPECT_LE(std::max(std::abs(error.cx_px), std::abs(error.cy_px)), kMaxCentreError_px);
    widest_focal = std::max(widest_focal, std::abs(error.focal));
    widest_centre = std::max(widest_centre, std::abs(error.cx_px));
    mean_focal += error.focal / kDraws;
  }
  EXPECT_GT(widest_focal, 0.95 * kMaxFocalError);
  EXPECT_GT(widest_centre, 0.95 * kMaxCentreError_px);
  EXPECT_LT(std::abs(mean_focal), 0.1 * kMaxFocalError);
}

TEST(LensError, is_given_at_a_width_of_640) {
  CameraIntrinsics nominal;
  nominal.width = 1280;
  nominal.height = 960;
  nominal.fx = nominal.fy = 1000;
  nominal.cx = 640;
  nominal.cy = 480;
  LensError error;
  error.focal = 0.03;
  error.cx_px = 8;
  error.cy_px = -8;
  const CameraIntrinsics exact = with_error(nominal, error);
  EXPECT_NEAR(exact.fx, 1030, 1e-9);
  EXPECT_NEAR(exact.fy, 1030, 1e-9);
  EXPECT_NEAR(exact.cx, 656, 1e-9);
  EXPECT_NEAR(exact.cy, 464, 1e-9);
  EXPECT_EQ(with_error(nominal, {}), nominal);
}

TEST(LensError, turns_and_shifts_the_colour_camera) {
  Random random(5);
  const RigidTransform moved = with_drawn_error({}, random);
  EXPECT_GT(Eigen::AngleAxisd(moved.rotation).angle(), 1e-4);
  EXPECT_LE(Eigen::AngleAxisd(moved.rotation).angle(), std::sqrt(3.0) * kMaxColorTurn_rad);
  EXPECT_GT(moved.translation_m.norm(), 1e-4);
  EXPECT_LE(moved.translation_m.norm(), std::sqrt(3.0) * kMaxColorShift_m);
}

}  // namespace
}  // namespace roomcast::simulator
