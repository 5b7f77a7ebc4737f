// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/vr_walk.h"

#include <gtest/gtest.h>

namespace roomcast::viewer::xr {
namespace {

constexpr double kRounding = 1e-9;

/// A head off the stage's centre, turned, as a real one is.
VrInput standing() {
  VrInput input;
  input.stage_from_head = world_from_view(look_from({0.4, 1.7, -0.3}, {1.4, 1.5, -0.3}));
  return input;
}

Eigen::Vector3d head_m(const VrWalk& walk, const VrInput& input) {
  return (walk.world_from_stage() * input.stage_from_head).translation_m;
}

Eigen::Vector3d gaze(const VrWalk& walk, const VrInput& input) {
  return (walk.world_from_stage() * input.stage_from_head).rotation * Eigen::Vector3d(0, 0, -1);
}

TEST(VrWalk, stands_at_the_given_place_at_its_own_height) {
  VrWalk walk;
  const VrInput input = standing();
  walk.stand_at(look_from({2, 1.2, 3}, {2, 1.2, 0}), input.stage_from_head);
  EXPECT_LT((head_m(walk, input) - Eigen::Vector3d(2, 1.7, 3)).norm(), kRounding);
  EXPECT_NEAR(gaze(walk, input).x(), 0, kRounding);
  EXPECT_LT(gaze(walk, input).z(), 0);
}

TEST(VrWalk, walks_where_the_head_looks) {
  VrWalk walk;
  VrInput input = standing();
  const Eigen::Vector3d before = head_m(walk, input);
  input.left.stick = {0, 1};
  walk.advance(input, {}, 0.1);
  const Eigen::Vector3d step = head_m(walk, input) - before;
  EXPECT_NEAR(step.x(), 0.1 * ComfortOptions{}.walk_speed_m_per_s, kRounding);
  EXPECT_NEAR(step.z(), 0, kRounding);
  EXPECT_EQ(step.y(), 0);
}

TEST(VrWalk, turns_by_one_step_for_each_push_around_the_head) {
  VrWalk walk;
  VrInput input = standing();
  const Eigen::Vector3d before = head_m(walk, input);
  input.right.stick = {1, 0};
  for (int i = 0; i < 5; ++i) walk.advance(input, {}, 0.01);
  EXPECT_LT((head_m(walk, input) - before).norm(), kRounding);
  const double once = std::acos(gaze(walk, input).normalized().dot(gaze(VrWalk{}, input)));
  EXPECT_NEAR(once, ComfortOptions{}.snap_rad, 0.02);
  EXPECT_GT(gaze(walk, input).z(), 0) << "to the right of +x";
  input.right.stick = {0, 0};
  walk.advance(input, {}, 0.01);
  input.right.stick = {-1, 0};
  walk.advance(input, {}, 0.01);
  EXPECT_LT((gaze(walk, input) - gaze(VrWalk{}, input)).norm(), kRounding) << "and back";
}

TEST(VrWalk, turns_smoothly_if_chosen) {
  VrWalk walk;
  ComfortOptions comfort;
  comfort.snap_turn = false;
  VrInput input = standing();
  input.right.stick = {-1, 0};
  walk.advance(input, comfort, 0.1);
  const Eigen::Vector3d once = gaze(walk, input);
  walk.advance(input, comfort, 0.1);
  EXPECT_LT(gaze(walk, input).z(), once.z()) << "to the left of +x, on and on";
}

TEST(VrWalk, teleports_when_the_stick_is_released) {
  VrWalk walk;
  VrInput input = standing();
  input.right.stage_from_aim = world_from_view(look_from({0.4, 1.2, -0.3}, {0.4, 1.2, -2}));
  input.right.stick = {0, 1};
  walk.advance(input, {}, 0.01);
  ASSERT_TRUE(walk.teleport_target_m());
  const Eigen::Vector3d target = *walk.teleport_target_m();
  EXPECT_EQ(target.y(), 0);
  EXPECT_LT(target.z(), -1.5);
  const double height = head_m(walk, input).y();
  input.right.stick = {0, 0};
  walk.advance(input, {}, 0.01);
  EXPECT_FALSE(walk.teleport_target_m());
  EXPECT_LT((head_m(walk, input) - Eigen::Vector3d(target.x(), height, target.z())).norm(),
            kRounding);
}

TEST(VrWalk, without_smooth_walking_the_walking_stick_teleports) {
  VrWalk walk;
  ComfortOptions comfort;
  comfort.smooth_walk = false;
  VrInput input = standing();
  input.left.stick = {0, 1};
  const Eigen::Vector3d before = head_m(walk, input);
  walk.advance(input, comfort, 0.1);
  EXPECT_EQ(head_m(walk, input), before);
  EXPECT_TRUE(walk.teleport_target_m());
}

TEST(VrWalk, left_handed_the_left_hand_turns_and_teleports) {
  VrWalk walk;
  VrInput input = standing();
  ComfortOptions comfort;
  comfort.left_handed = true;
  const Eigen::Vector3d before = head_m(walk, input), straight = gaze(walk, input);
  input.right.stick = {0, 1};
  walk.advance(input, comfort, 0.1);
  EXPECT_GT((head_m(walk, input) - before).norm(), 0.1);
  EXPECT_FALSE(walk.teleport_target_m());
  input.right.stick = {0, 0};
  input.left.stick = {1, 0};
  walk.advance(input, comfort, 0.1);
  EXPECT_GT((gaze(walk, input) - straight).norm(), 0.1);
  input.left.stick = {0, 1};
  input.left.stage_from_aim = input.stage_from_head;
  walk.advance(input, comfort, 0.1);
  EXPECT_TRUE(walk.teleport_target_m());
}

TEST(VrWalk, the_only_button_of_a_simple_controller_teleports_and_the_other_hands_points) {
  VrWalk walk;
  VrInput input = standing();
  input.right.selects = true;
  input.right.stage_from_aim = input.stage_from_head;
  walk.advance(input, {}, 0.01);
  ASSERT_TRUE(walk.teleport_target_m());
  const Eigen::Vector3d target_m = *walk.teleport_target_m();
  EXPECT_EQ(input.pointing_hand({}), nullptr);
  input.right.selects = false;
  walk.advance(input, {}, 0.01);
  EXPECT_NEAR(head_m(walk, input).x(), target_m.x(), kRounding);
  EXPECT_NEAR(head_m(walk, input).z(), target_m.z(), kRounding);
  input.left.selects = true;
  EXPECT_EQ(input.pointing_hand({}), &input.left);
}

TEST(LandingPlace, is_nearer_for_a_lower_aim_and_missing_beyond_the_reach) {
  const auto aim = [](double pitch) {
    ViewState view;
    view.position_m = {0, 1.2, 0};
    view.pitch_rad = pitch;
    return world_from_view(view);
  };
  EXPECT_LT(landing_place_m(aim(-1))->norm(), landing_place_m(aim(0))->norm());
  EXPECT_TRUE(landing_place_m(aim(kMaxPitch_rad))) << "straight up comes down again";
  RigidTransform below = aim(0);
  below.translation_m.y() = -1;
  EXPECT_FALSE(landing_place_m(below));
  RigidTransform high = aim(0.5);
  high.translation_m.y() = 30;
  EXPECT_FALSE(landing_place_m(high));
}

}  // namespace
}  // namespace roomcast::viewer::xr
