// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/homography/homography_pose.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

/// A view of a wall from `aside_m` to the side, so that one plane fills most of it.
ViewFixture facing_wall(const char* name, double aside_m) {
  RoomFixture room;
  room.boxes = {{Eigen::Vector3d(-1.1, 0, -2), Eigen::Vector3d(-0.3, 1, -1.5)}};
  return view_fixture(room, name,
                      world_from_optical_looking_at({aside_m, 1.4, 0.6}, {aside_m, 1.2, -2}));
}

TEST(HomographyPose, is_right_for_a_wall_seen_from_almost_the_same_place) {
  const ViewFixture a = facing_wall("a", 0), b = facing_wall("b", 0.08);
  const auto pose = homography_pose(*a.view, *b.view);
  ASSERT_TRUE(pose.has_value());
  EXPECT_LT(difference(pose->a_from_b, true_pose(a, b)).angle_rad, 0.05);
  EXPECT_LT(difference(pose->a_from_b, true_pose(a, b)).distance_m, 0.1);
  EXPECT_GE(pose->inliers, 8);
}

TEST(HomographyPose, is_the_same_every_time) {
  const ViewFixture a = facing_wall("a", 0), b = facing_wall("b", 0.08);
  const auto one = homography_pose(*a.view, *b.view), other = homography_pose(*a.view, *b.view);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->a_from_b.rotation, other->a_from_b.rotation);
}

TEST(AlignByHomography, puts_the_first_sensor_into_the_origin) {
  const ViewFixture a = facing_wall("a", 0), b = facing_wall("b", 0.08);
  const std::vector<std::shared_ptr<const SensorView>> views = {a.view, b.view};
  const AlignmentReport report = align_by_homography(views);
  ASSERT_EQ(report.sensors.size(), 2u);
  ASSERT_EQ(report.pairs.size(), 1u);
  EXPECT_TRUE(report.sensors[0].placed);
  EXPECT_EQ(report.sensors[1].placed, report.pairs[0].accepted);
  EXPECT_NEAR(report.sensors[0].world_from_depth->translation_m.x(), 0, 1e-9);
  EXPECT_TRUE(align_by_homography({}).sensors.empty());
}

}  // namespace
}  // namespace roomcast::alignment
