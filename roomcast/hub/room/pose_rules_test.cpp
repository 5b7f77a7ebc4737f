// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/pose_rules.h"

#include <gtest/gtest.h>

#include "roomcast/wire/pose_message.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

RigidTransform transform_at(double x) {
  return {Eigen::Matrix3d::Identity(), {x, 0, 0}};
}

pb::SensorPlacement found_at(double x) {
  pb::SensorPlacement found;
  wire::write_transform(transform_at(x), *found.mutable_world_from_depth());
  found.set_expected_error_mm(4);
  return found;
}

pb::SensorRole role_at(double x) {
  pb::SensorRole role;
  wire::write_transform(transform_at(x), *role.mutable_world_from_depth());
  return role;
}

SensorPose estimated_at(double x) {
  SensorPose pose;
  EXPECT_TRUE(take_estimate(found_at(x), pose));
  return pose;
}

SensorPose stored_at(double x) {
  SensorPose pose = estimated_at(x);
  doubt(pose);
  return pose;
}

pb::SensorPlacement withdrawn_because(const std::string& reason) {
  pb::SensorPlacement withdrawn;
  withdrawn.set_withdrawn(true);
  withdrawn.set_note(reason);
  return withdrawn;
}

TEST(PoseRules, placeholders_differ_from_sensor_to_sensor) {
  EXPECT_NE(placeholder_pose(0).translation_m, placeholder_pose(1).translation_m);
}

TEST(PoseRules, a_placeholder_lies_well_outside_of_where_the_placed_ones_stand) {
  const RigidTransform placed[] = {transform_at(-7), transform_at(4), transform_at(1)};
  EXPECT_GE(placeholder_pose(0, placed).translation_m.x(), 9);
  EXPECT_GE(placeholder_pose(1, placed).translation_m.x(), 12);
}

TEST(PoseRules, an_estimate_is_valid_until_the_next_one) {
  SensorPose pose = estimated_at(1);
  EXPECT_EQ(pose.source, PoseSource::kEstimated);
  EXPECT_EQ(pose.state, PoseState::kValid);
  EXPECT_TRUE(take_estimate(found_at(2), pose));
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 2);
  EXPECT_EQ(pose.expected_error_mm, 4);
  pb::SensorPlacement lost;
  lost.set_note("it shares nothing");
  EXPECT_FALSE(take_estimate(lost, pose));
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 2);
  EXPECT_EQ(pose.note, "it shares nothing");
}

TEST(PoseRules, an_estimate_can_be_withdrawn) {
  SensorPose pose = estimated_at(1);
  EXPECT_TRUE(take_estimate(withdrawn_because("nothing connects it with the others"), pose));
  EXPECT_FALSE(pose.is_placed());
  EXPECT_EQ(pose.state, PoseState::kNone);
  EXPECT_EQ(pose.expected_error_mm, 0);
  EXPECT_EQ(pose.note, "nothing connects it with the others");
  EXPECT_FALSE(take_estimate(withdrawn_because("again"), pose)) << "nothing new";
}

TEST(PoseRules, a_sensor_stays_moved_when_its_estimate_is_withdrawn) {
  SensorPose pose = estimated_at(1);
  pose.state = PoseState::kMoved;
  EXPECT_TRUE(take_estimate(withdrawn_because("nothing connects it with the others"), pose));
  EXPECT_FALSE(pose.is_placed());
  EXPECT_TRUE(pose.is_moved());
  EXPECT_TRUE(take_estimate(found_at(2), pose));
  EXPECT_EQ(pose.state, PoseState::kValid);
}

TEST(PoseRules, a_stored_pose_is_unverified_until_it_is_found_again) {
  SensorPose pose = stored_at(1);
  EXPECT_EQ(pose.source, PoseSource::kStored);
  EXPECT_EQ(pose.state, PoseState::kUnverified);
  pb::SensorPlacement unknown;
  unknown.set_note("nothing to compare it with");
  EXPECT_FALSE(take_estimate(unknown, pose));
  EXPECT_EQ(pose.state, PoseState::kUnverified);
  EXPECT_TRUE(take_estimate(found_at(1), pose));
  EXPECT_EQ(pose.source, PoseSource::kEstimated);
  EXPECT_EQ(pose.state, PoseState::kValid);
}

TEST(PoseRules, a_stored_pose_can_be_confirmed) {
  SensorPose pose = stored_at(1);
  confirm(pose);
  EXPECT_EQ(pose.source, PoseSource::kEstimated);
  EXPECT_EQ(pose.state, PoseState::kValid);
}

TEST(PoseRules, what_one_hub_has_not_verified_the_other_has_not_either) {
  auto found = found_at(1);
  found.set_unverified(true);
  SensorPose pose;
  EXPECT_TRUE(take_estimate(found, pose));
  EXPECT_EQ(pose.state, PoseState::kUnverified);
}

TEST(PoseRules, a_pose_that_was_given_needs_nobody_who_verifies_it) {
  SensorPose pose = stored_at(1);
  take_given(role_at(5), pose);
  EXPECT_EQ(pose.state, PoseState::kValid);
  doubt(pose);
  EXPECT_EQ(pose.state, PoseState::kValid);
}

TEST(PoseRules, a_pose_that_is_found_again_keeps_its_very_numbers) {
  SensorPose pose = estimated_at(1);
  EXPECT_TRUE(take_estimate(found_at(1 + 1e-13), pose));
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 1);
  EXPECT_TRUE(take_estimate(found_at(1.001), pose));
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 1.001);
}

TEST(PoseRules, what_is_given_goes_before_what_is_estimated) {
  SensorPose pose = stored_at(1);
  take_given({}, pose);
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 1) << "it says nothing";
  take_given(role_at(5), pose);
  EXPECT_FALSE(take_estimate(found_at(2), pose));
  EXPECT_EQ(pose.source, PoseSource::kGiven);
  EXPECT_EQ(pose.world_from_depth.translation_m.x(), 5);
  EXPECT_EQ(pose.expected_error_mm, 0);
}

TEST(PoseRules, a_given_pose_is_replaced_once_the_sensor_was_moved) {
  SensorPose pose;
  take_given(role_at(5), pose);
  pose.state = PoseState::kMoved;
  EXPECT_TRUE(take_estimate(found_at(2), pose));
  EXPECT_EQ(pose.source, PoseSource::kEstimated);
  EXPECT_EQ(pose.state, PoseState::kValid);
}

}  // namespace
}  // namespace roomcast::hub
