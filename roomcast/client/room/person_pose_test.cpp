// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/person_pose.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"

namespace roomcast::client {
namespace {

constexpr double kFloatRounding = 1e-6;

RigidTransform turned(double yaw_rad, const Eigen::Vector3d& place_m) {
  return {Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY()).toRotationMatrix(), place_m};
}

TEST(PersonPose, a_pose_that_was_sent_is_the_pose_that_arrives) {
  PersonPose sent;
  sent.world_from_head = turned(0.7, {1, 1.6, -2});
  sent.world_from_right_hand = turned(-2.5, {1.2, 1.1, -2.3});
  sent.pointer = PointerBeam{{1.2, 1.1, -2.3}, {0, 0, 1}};
  const PersonPose arrived = pose_from_message(message_from_pose(sent));
  EXPECT_TRUE(
      arrived.world_from_head.rotation.isApprox(sent.world_from_head.rotation, kFloatRounding));
  EXPECT_TRUE(arrived.world_from_head.translation_m.isApprox(sent.world_from_head.translation_m,
                                                             kFloatRounding));
  ASSERT_TRUE(arrived.world_from_right_hand);
  EXPECT_TRUE(arrived.world_from_right_hand->rotation.isApprox(sent.world_from_right_hand->rotation,
                                                               kFloatRounding));
  EXPECT_FALSE(arrived.world_from_left_hand) << "a hand that nobody tracks stays away";
  ASSERT_TRUE(arrived.pointer);
  EXPECT_TRUE(arrived.pointer->from_m.isApprox(sent.pointer->from_m, kFloatRounding));
  EXPECT_TRUE(arrived.pointer->to_m.isApprox(sent.pointer->to_m, kFloatRounding));
}

TEST(PersonPose, a_sent_pose_obeys_the_rules_of_the_wire) {
  PersonPose pose;
  pose.world_from_head = turned(3.1, {0, 0, 0});
  pose.world_from_left_hand = turned(1, {5, 5, 5});
  wire::pb::Control control;
  *control.mutable_viewer_pose() = message_from_pose(pose);
  EXPECT_TRUE(wire::check_control(control).ok());
}

}  // namespace
}  // namespace roomcast::client
