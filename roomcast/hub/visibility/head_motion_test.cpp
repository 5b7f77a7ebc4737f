// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/head_motion.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

RoomTime head_time(nanoseconds time) {
  return RoomTime(1h + time);
}

/// At (x, 1.6, 0), turned to the left by this angle.
wire::pb::Pose head(float x, float left_rad) {
  wire::pb::Pose pose;
  pose.set_x(x);
  pose.set_y(1.6F);
  pose.set_qy(std::sin(left_rad / 2));
  pose.set_qw(std::cos(left_rad / 2));
  return pose;
}

Eigen::Vector3f direction(float left_rad) {
  return {-std::sin(left_rad), 0, -std::cos(left_rad)};
}

TEST(HeadMotion, goes_on_as_it_moved) {
  HeadMotion motion;
  motion.moved(head(0, 0), head_time(0s));
  motion.moved(head(0.1F, 0.2F), head_time(100ms));
  EXPECT_LT((motion.now().forward - direction(0.2F)).norm(), 1e-4F);
  const auto ahead = motion.at(head_time(300ms), head_time(100ms));
  EXPECT_LT((ahead.at_m - Eigen::Vector3f(0.3F, 1.6F, 0)).norm(), 1e-4F);
  EXPECT_LT((ahead.forward - direction(0.6F)).norm(), 1e-4F);
}

TEST(HeadMotion, what_is_up_turns_along) {
  HeadMotion motion;
  wire::pb::Pose bent = head(0, 0);  // forward and down
  bent.set_qx(std::sin(-0.3F));
  bent.set_qw(std::cos(-0.3F));
  motion.moved(head(0, 0), head_time(0s));
  motion.moved(bent, head_time(100ms));
  EXPECT_LT((motion.now().up - Eigen::Vector3f(0, std::cos(0.6F), -std::sin(0.6F))).norm(), 1e-4F);
  const auto ahead = motion.at(head_time(200ms), head_time(100ms));
  EXPECT_NEAR(ahead.up.dot(ahead.forward), 0, 1e-4);
  EXPECT_NEAR(ahead.up.y(), std::cos(1.2F), 1e-3);
}

TEST(HeadMotion, is_at_rest_after_a_while) {
  HeadMotion motion;
  motion.moved(head(0, 0), head_time(0s));
  motion.moved(head(0.1F, 0.2F), head_time(100ms));
  EXPECT_EQ(motion.at(head_time(2s), head_time(1s)).at_m, motion.now().at_m);
  motion.moved(head(0.2F, 0.4F), head_time(1s));  // after a rest: a step, not a velocity
  EXPECT_EQ(motion.at(head_time(1300ms), head_time(1s)).at_m, motion.now().at_m);
}

TEST(HeadMotion, a_head_that_jumps_moves_no_faster_than_people_do) {
  HeadMotion motion;
  for (int i = 0; i < 100; ++i)
    motion.moved(head(i % 2 == 0 ? -9000.0F : 9000.0F, i % 2 == 0 ? 0.0F : 3.0F),
                 head_time(i * 10ms));
  const auto ahead = motion.at(head_time(990ms + 100ms), head_time(990ms));
  EXPECT_LT((ahead.at_m - motion.now().at_m).norm(), 0.5F);
  EXPECT_TRUE(ahead.forward.allFinite());
  EXPECT_NEAR(ahead.forward.norm(), 1, 1e-4);
}

TEST(HeadMotion, a_head_that_turns_right_around_stays_finite) {
  HeadMotion motion;
  motion.moved(head(0, 0), head_time(0s));
  motion.moved(head(0, 3.14159265F), head_time(100ms));
  EXPECT_TRUE(motion.at(head_time(400ms), head_time(100ms)).forward.allFinite());
}

}  // namespace
}  // namespace roomcast::hub
