// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/visibility_check.h"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

pb::Control coarse_depth(unsigned columns, unsigned rows, unsigned cells) {
  pb::Control control;
  auto& depth = *control.mutable_coarse_depth();
  depth.set_columns(columns);
  depth.set_rows(rows);
  for (unsigned cell = 0; cell < cells; ++cell) {
    depth.add_near_cm(100);
    depth.add_far_cm(200);
  }
  return control;
}

TEST(VisibilityCheck, coarse_depth_has_two_distances_of_each_of_a_few_cells) {
  EXPECT_TRUE(check_control(coarse_depth(12, 9, 108)));
  EXPECT_TRUE(check_control(coarse_depth(kMaxCoarseSide, kMaxCoarseSide, 64 * 64)));
  EXPECT_FALSE(check_control(coarse_depth(12, 9, 107)));
  EXPECT_FALSE(check_control(coarse_depth(0, 9, 0)));
  EXPECT_FALSE(check_control(coarse_depth(kMaxCoarseSide + 1, 1, kMaxCoarseSide + 1)));
  // Their product overflows to 0.
  EXPECT_FALSE(check_control(coarse_depth(1U << 16, 1U << 16, 0)));
  pb::Control lacks_far = coarse_depth(2, 2, 4);
  lacks_far.mutable_coarse_depth()->mutable_far_cm()->RemoveLast();
  EXPECT_FALSE(check_control(lacks_far));
}

TEST(VisibilityCheck, unseen_sensors_are_at_most_those_of_a_room) {
  pb::Control control;
  auto& unseen = *control.mutable_unseen_sensors();
  EXPECT_TRUE(check_control(control));
  for (std::size_t i = 0; i < kMaxSensors; ++i) unseen.add_paused(1);
  EXPECT_TRUE(check_control(control));
  unseen.add_paused(1);
  EXPECT_EQ(check_control(control).error().code, ErrorCode::kTooLarge);
  unseen.clear_paused();
  for (std::size_t i = 0; i <= kMaxSensors; ++i) unseen.add_base_only(1);
  EXPECT_FALSE(check_control(control));
}

TEST(VisibilityCheck, half_an_angle_of_view_is_at_most_half_a_turn) {
  pb::Control control;
  auto& pose = *control.mutable_viewer_pose();
  pose.mutable_head()->set_qw(1);
  for (const float angle : {0.0F, 0.9F, kMaxViewHalfAngle_rad}) {
    pose.set_view_half_angle(angle);
    EXPECT_TRUE(check_control(control)) << angle;
  }
  for (const float angle : {-0.1F, 3.2F, std::numeric_limits<float>::quiet_NaN()}) {
    pose.set_view_half_angle(angle);
    EXPECT_FALSE(check_control(control)) << angle;
    pose.set_view_half_angle(1);
    pose.set_view_half_width(angle);
    EXPECT_FALSE(check_control(control)) << angle;
    pose.set_view_half_width(1);
    pose.set_view_half_height(angle);
    EXPECT_FALSE(check_control(control)) << angle;
    pose.set_view_half_height(1);
    EXPECT_TRUE(check_control(control));
  }
}

TEST(VisibilityCheck, a_share_of_an_uplink_is_a_rate) {
  pb::Control control;
  for (const double mbit : {0.0, 0.1, 1000.0}) {
    control.mutable_frame_demand()->set_mbit(mbit);
    EXPECT_TRUE(check_control(control)) << mbit;
  }
  for (const double mbit : {-1.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
    control.mutable_frame_demand()->set_mbit(mbit);
    EXPECT_FALSE(check_control(control)) << mbit;
  }
}

pb::ViewCone& add_cone(pb::Control& control) {
  pb::ViewCone& cone = *control.mutable_watched_from()->add_cones();
  cone.mutable_eye()->set_y(-1.5F);
  cone.mutable_forward()->set_z(1);
  cone.set_half_angle(0.8F);
  cone.mutable_up()->set_y(1);
  return cone;
}

TEST(VisibilityCheck, there_are_a_few_cones_of_view) {
  pb::Control control;
  control.mutable_watched_from();
  EXPECT_TRUE(check_control(control));
  for (int i = 0; i < kMaxViewCones; ++i) add_cone(control);
  EXPECT_TRUE(check_control(control));
  add_cone(control);
  EXPECT_EQ(check_control(control).error().code, ErrorCode::kTooLarge);
}

TEST(VisibilityCheck, a_cone_of_view_has_an_eye_a_direction_and_an_angle) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const std::function<void(pb::ViewCone&)> faults[] = {
      [](auto& cone) { cone.mutable_eye()->set_x(kNone); },
      [](auto& cone) { cone.mutable_eye()->set_z(2e4F); },
      [](auto& cone) { cone.clear_forward(); },
      [](auto& cone) { cone.mutable_forward()->set_y(1); },
      [](auto& cone) { cone.mutable_forward()->set_x(kNone); },
      [](auto& cone) { cone.set_half_angle(-0.1F); },
      [](auto& cone) { cone.set_half_angle(kNone); },
      [](auto& cone) { cone.set_half_width(-0.1F); },
      [](auto& cone) { cone.set_half_height(kNone); },
      [](auto& cone) { cone.mutable_up()->set_x(1); },
      [](auto& cone) { cone.mutable_up()->set_x(kNone); },
      [](auto& cone) {
        cone.mutable_up()->set_y(0);
        cone.mutable_up()->set_z(1);
      }};
  for (const auto& spoil : faults) {
    pb::Control control;
    add_cone(control);
    spoil(add_cone(control));
    EXPECT_FALSE(check_control(control)) << control.ShortDebugString();
  }
}

}  // namespace
}  // namespace roomcast::wire
