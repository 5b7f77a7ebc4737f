// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pose_difference.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

constexpr double kDegree_rad = M_PI / 180;

/// A pose whose view at 2.5 m stays in place while the sensor turns about it.
RigidTransform turned_about_its_view(double angle_rad) {
  RigidTransform pose;
  pose.rotation = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Vector3d view_m(0, 0, 2.5);
  pose.translation_m = view_m - pose.rotation * view_m;
  return pose;
}

RigidTransform pose_aside(double x_m) {
  RigidTransform pose;
  pose.translation_m.x() = x_m;
  return pose;
}

TEST(PoseDifference, knows_every_angle_from_a_hair_to_half_a_turn) {
  for (const double angle_rad : {1e-6, 0.01, 1.0, 2.0, M_PI}) {
    EXPECT_NEAR(difference(turned_about_its_view(angle_rad), {}).angle_rad, angle_rad, 1e-7);
    EXPECT_NEAR(difference({}, turned_about_its_view(angle_rad)).angle_rad, angle_rad, 1e-7);
  }
}

TEST(PoseDifference, is_measured_where_it_is_asked_for) {
  const RigidTransform turned = turned_about_its_view(0.2);
  EXPECT_NEAR(difference(turned, {}).distance_m, 0, 1e-12);
  EXPECT_NEAR(difference(turned, {}, {0, 0, 0}).distance_m, 2 * 2.5 * std::sin(0.1), 1e-12);
  EXPECT_NEAR(difference(pose_aside(3), pose_aside(-1), {7, 8, 9}).distance_m, 4, 1e-12);
}

TEST(PoseDifference, of_a_pose_to_itself_is_nothing) {
  const RigidTransform pose = pose_aside(1) * turned_about_its_view(1);
  EXPECT_EQ(difference(pose, pose).distance_m, 0);
  EXPECT_LT(difference(pose, pose).angle_rad, 1e-14);
}

TEST(PoseDifference, rivals_are_more_than_four_degrees_or_twenty_centimetres_apart) {
  EXPECT_FALSE(are_rivals(turned_about_its_view(3.9 * kDegree_rad), {}));
  EXPECT_TRUE(are_rivals(turned_about_its_view(4.1 * kDegree_rad), {}));
  EXPECT_FALSE(are_rivals(pose_aside(0.19), {}));
  EXPECT_TRUE(are_rivals(pose_aside(-0.21), {}));
}

}  // namespace
}  // namespace roomcast::alignment
