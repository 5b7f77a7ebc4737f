// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/lens.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr float kSinglePrecision_px = 1e-3F;

TEST(Lens, projects_as_the_camera_model_does) {
  const CameraIntrinsics camera = calibration_fixture().depth;
  const Lens lens(camera);
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.5, -0.3, 1.4), Eigen::Vector3d(-0.6, 0.5, 1)}) {
    Eigen::Vector2f pixel;
    ASSERT_TRUE(lens.project(point.cast<float>(), pixel));
    EXPECT_LT((pixel - project(camera, point)->cast<float>()).norm(), kSinglePrecision_px);
  }
}

TEST(Lens, projects_nothing_from_behind_or_far_outside) {
  const Lens lens(calibration_fixture().depth);
  Eigen::Vector2f pixel;
  EXPECT_FALSE(lens.project({0, 0, -1}, pixel));
  EXPECT_FALSE(lens.project({0, 0, 0}, pixel));
  EXPECT_FALSE(lens.project({9, 0, 1}, pixel));
}

}  // namespace
}  // namespace roomcast::alignment
