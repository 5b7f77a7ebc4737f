// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/view_state.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

constexpr double kViewStateRounding = 1e-9;

const ViewState kStart = look_from({1, 1.6, 3}, {0, 1, -1});

void expect_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EXPECT_LT((a - b).norm(), kViewStateRounding) << a.transpose() << " and " << b.transpose();
}

TEST(ViewState, looks_at_its_target) {
  expect_near(pivot_m(kStart), {0, 1, -1});
  EXPECT_NEAR(look_from({0, 0, 0}, {-2, 0, 0}).yaw_rad, EIGEN_PI / 2, kViewStateRounding);
}

TEST(ViewState, has_a_pose_that_turns_minus_z_into_its_direction_and_keeps_the_horizon_level) {
  const RigidTransform pose = world_from_view(kStart);
  expect_near(pose.rotation * Eigen::Vector3d(0, 0, -1), direction(kStart));
  EXPECT_NEAR((pose.rotation * Eigen::Vector3d(1, 0, 0)).y(), 0, kViewStateRounding);
}

TEST(ViewState, straight_down_or_at_its_own_place_is_still_a_direction) {
  for (const Eigen::Vector3d& target : {Eigen::Vector3d(1, 0, 3), Eigen::Vector3d(1, 1.6, 3)}) {
    const ViewState view = look_from({1, 1.6, 3}, target);
    EXPECT_LE(std::abs(view.pitch_rad), kMaxPitch_rad);
    EXPECT_TRUE(std::isfinite(view.yaw_rad));
  }
}

TEST(ViewState, orbits_around_its_pivot_at_the_same_distance) {
  const ViewState turned = orbit(kStart, 0.7, -0.2);
  expect_near(pivot_m(turned), pivot_m(kStart));
  EXPECT_NEAR((turned.position_m - pivot_m(kStart)).norm(), kStart.pivot_distance_m,
              kViewStateRounding);
  EXPECT_GT((turned.position_m - kStart.position_m).norm(), 1);
}

TEST(ViewState, turns_its_head_in_place_and_never_past_straight_up) {
  expect_near(look(kStart, 1, 0.1).position_m, kStart.position_m);
  EXPECT_EQ(look(kStart, 0, 10).pitch_rad, kMaxPitch_rad);
}

TEST(ViewState, pans_across_the_line_of_sight) {
  const Eigen::Vector3d move = pan(kStart, 2, 1).position_m - kStart.position_m;
  EXPECT_NEAR(move.dot(direction(kStart)), 0, kViewStateRounding);
  EXPECT_NEAR(move.norm(), std::sqrt(5.0), kViewStateRounding);
}

TEST(ViewState, zooms_towards_its_pivot_and_through_it_in_the_end) {
  const ViewState near = dolly(kStart, 0.5);
  expect_near(pivot_m(near), pivot_m(kStart));
  EXPECT_NEAR(near.pivot_distance_m, kStart.pivot_distance_m / 2, kViewStateRounding);
  ViewState view = kStart;
  for (int i = 0; i < 60; ++i) view = dolly(view, 0.8);
  EXPECT_GE(view.pivot_distance_m, kMinPivotDistance_m);
  EXPECT_GT((pivot_m(view) - pivot_m(kStart)).norm(), 0.5);
}

TEST(ViewState, walks_on_the_level_even_when_it_looks_down) {
  ViewState down = kStart;
  down.yaw_rad = 0;
  down.pitch_rad = -1;
  expect_near(walk(down, 2, 1, 0).position_m - down.position_m, {1, 0, -2});
  expect_near(walk(down, 0, 0, 0.5).position_m - down.position_m, {0, 0.5, 0});
}

TEST(ViewState, is_read_from_a_pose) {
  const ViewState view = view_from_pose(world_from_view(kStart), 2);
  expect_near(view.position_m, kStart.position_m);
  expect_near(direction(view), direction(kStart));
  EXPECT_EQ(view.pivot_distance_m, 2);
}

TEST(ViewState, stays_where_a_hub_still_takes_its_pose) {
  EXPECT_LE(walk(kStart, 1e9, 1e9, 1e9).position_m.cwiseAbs().maxCoeff(), kFarthestWalk_m);
}

}  // namespace
}  // namespace roomcast::viewer
