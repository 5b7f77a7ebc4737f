// SPDX-License-Identifier: Apache-2.0
// Two sensors side by side in front of a wall: the surfaces hold three unknowns, the matches the
// rest.
#include "roomcast/alignment/pair/pose_refinement.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kRefinedTo_m = 0.001;  // exact input; the steps end below 0.1 mm

RigidTransform off_by_some_centimetres(const RigidTransform& pose) {
  Vector6 step;
  step << 0.01, -0.01, 0.02, 0.02, -0.02, 0.03;
  return step_transform(step) * pose;
}

TEST(PoseRefinement, finds_the_pose_by_surfaces_and_matches) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 0.6);
  const RigidTransform truth = wall_pose(0, 0.6), start = off_by_some_centimetres(truth);
  ASSERT_GT(difference(start, truth).distance_m, 0.04);
  const PairState found = refined_pose(a, b, wall_matches(a, b, truth), start);
  EXPECT_LT(difference(found.a_from_b, truth).distance_m, kRefinedTo_m);
  EXPECT_TRUE(found.a.color_shift_px.isZero());
  EXPECT_TRUE(found.b.color_shift_px.isZero());
}

TEST(PoseRefinement, without_matches_fits_the_wall_and_does_not_slide_along_it) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 0.6);
  RigidTransform start = wall_pose(0, 0.6);
  start.translation_m += Eigen::Vector3d(0.05, 0.03, 0.06);
  const RigidTransform found = refined_pose(a, b, {}, start).a_from_b;
  EXPECT_NEAR(found.translation_m.z(), 0, kRefinedTo_m);
  EXPECT_NEAR(found.translation_m.x(), 0.65, kRefinedTo_m);
  EXPECT_NEAR(found.translation_m.y(), 0.03, kRefinedTo_m);
}

TEST(PoseRefinement, follows_only_matches_that_agree_with_the_start) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 0.6);
  const RigidTransform start = wall_pose(0, 0.6);
  // Matches agree within 8 cm.
  const RigidTransform near = wall_pose(0, 0.65), far = wall_pose(0, 0.7);
  const auto refined_to = [&](const RigidTransform& matched) {
    return refined_pose(a, b, wall_matches(a, b, matched), start).a_from_b;
  };
  EXPECT_LT(difference(refined_to(near), near).distance_m, kRefinedTo_m);
  EXPECT_LT(difference(refined_to(far), start).distance_m, kRefinedTo_m);
}

TEST(PoseRefinement, where_nothing_is_shared_the_pose_stays) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 5);
  const RigidTransform start = wall_pose(0, 5);
  for (const ColorCalibration color :
       {ColorCalibration::kAsCalibrated, ColorCalibration::kUncertain}) {
    const PairState found = refined_pose(a, b, {}, start, color);
    EXPECT_EQ(found.a_from_b.translation_m, start.translation_m);
    EXPECT_EQ(found.a_from_b.rotation, start.rotation);
    EXPECT_TRUE(found.b.color_shift_px.isZero());
  }
}

}  // namespace
}  // namespace roomcast::alignment
