// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/navigation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kFov_rad = 1;
constexpr double kHeight_px = 500;

ViewState start() {
  return look_from({0, 1.6, 0}, {0, 1.6, -2});
}

Eigen::Vector3d moved_m(const Navigation& navigation) {
  return navigation.view().position_m - start().position_m;
}

TEST(Navigation, walks_while_a_key_is_held) {
  Navigation navigation(start());
  EXPECT_FALSE(navigation.is_walking());
  navigation.hold(WalkKey::kForward, true);
  EXPECT_TRUE(navigation.is_walking());
  navigation.advance(0.05);
  navigation.hold(WalkKey::kForward, false);
  navigation.advance(0.05);
  EXPECT_LT((moved_m(navigation) - Eigen::Vector3d(0, 0, -0.05 * kWalkSpeed_m_per_s)).norm(),
            kRounding);
}

TEST(Navigation, each_key_goes_its_way) {
  const std::pair<WalkKey, Eigen::Vector3d> ways[] = {
      {WalkKey::kForward, {0, 0, -1}}, {WalkKey::kBack, {0, 0, 1}}, {WalkKey::kLeft, {-1, 0, 0}},
      {WalkKey::kRight, {1, 0, 0}},    {WalkKey::kUp, {0, 1, 0}},   {WalkKey::kDown, {0, -1, 0}}};
  for (const auto& [key, way] : ways) {
    Navigation navigation(start());
    navigation.hold(key, true);
    navigation.advance(0.1);
    EXPECT_LT((moved_m(navigation) - 0.1 * kWalkSpeed_m_per_s * way).norm(), kRounding);
  }
}

TEST(Navigation, opposite_keys_cancel_out_and_running_is_faster) {
  Navigation navigation(start());
  navigation.hold(WalkKey::kLeft, true);
  navigation.hold(WalkKey::kRight, true);
  navigation.advance(0.1);
  EXPECT_LT(moved_m(navigation).norm(), kRounding);
  navigation.hold(WalkKey::kLeft, false);
  navigation.run(true);
  navigation.advance(0.1);
  EXPECT_GT(moved_m(navigation).x(), 0.1 * kWalkSpeed_m_per_s);
}

TEST(Navigation, a_machine_that_slept_does_not_walk_through_the_wall) {
  Navigation navigation(start());
  navigation.hold(WalkKey::kForward, true);
  navigation.advance(3600);
  EXPECT_LT(moved_m(navigation).norm(), 0.5);
}

TEST(Navigation, forgets_held_keys_when_the_window_loses_the_keyboard) {
  Navigation navigation(start());
  navigation.hold(WalkKey::kForward, true);
  navigation.release_all();
  navigation.advance(0.1);
  EXPECT_EQ(moved_m(navigation).norm(), 0);
}

TEST(Navigation, a_stick_at_rest_does_nothing_and_a_full_one_walks_at_full_speed) {
  Navigation navigation(start());
  navigation.set_sticks({.walk_right = 0.14, .look_right = -0.14});
  EXPECT_FALSE(navigation.is_walking());
  navigation.advance(0.1);
  EXPECT_EQ(moved_m(navigation).norm(), 0);
  navigation.set_sticks({.walk_forward = 1, .look_right = 0.5});
  EXPECT_TRUE(navigation.is_walking());
  navigation.advance(0.1);
  EXPECT_NEAR(moved_m(navigation).z(), -0.1 * kWalkSpeed_m_per_s, kRounding);
  EXPECT_LT(navigation.view().yaw_rad, 0) << "to the right";
}

TEST(Navigation, dragging_to_the_right_turns_the_room_to_the_right) {
  Navigation orbiting(start()), looking(start());
  orbiting.drag(Drag::kOrbit, 100, 0, kHeight_px, kFov_rad);
  looking.drag(Drag::kLook, 100, 0, kHeight_px, kFov_rad);
  EXPECT_LT(orbiting.view().position_m.x(), 0) << "the eye goes the other way";
  EXPECT_LT((pivot_m(orbiting.view()) - pivot_m(start())).norm(), kRounding);
  EXPECT_LT(looking.view().yaw_rad, 0);
  EXPECT_EQ(looking.view().position_m, start().position_m);
}

TEST(Navigation, the_pivot_follows_a_panning_mouse) {
  Navigation navigation(start());
  navigation.drag(Drag::kPan, 0, kHeight_px / 2, kHeight_px, kFov_rad);
  EXPECT_NEAR(moved_m(navigation).y(), 2 * std::tan(kFov_rad / 2), kRounding);
}

TEST(Navigation, the_wheel_goes_nearer_and_back) {
  Navigation navigation(start());
  navigation.zoom(1);
  EXPECT_LT(navigation.view().pivot_distance_m, 2);
  navigation.zoom(-1);
  EXPECT_LT(moved_m(navigation).norm(), kRounding);
}

TEST(Navigation, speed_stays_within_what_a_person_can_steer) {
  Navigation navigation(start());
  navigation.change_speed(1);
  EXPECT_GT(navigation.speed_m_per_s(), kWalkSpeed_m_per_s);
  navigation.change_speed(1000);
  EXPECT_EQ(navigation.speed_m_per_s(), kFastestWalk_m_per_s);
  navigation.change_speed(-1000);
  EXPECT_EQ(navigation.speed_m_per_s(), kSlowestWalk_m_per_s);
}

}  // namespace
}  // namespace roomcast::viewer
