// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/walking_body.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Walk test_walk() {
  return {{0.5F, -0.2F}, {1.0F, 0.9F}, seconds(7), 5};
}

float lowest_point_m(const WalkingBody& body) {
  float lowest = 10.0F;
  for (const BodyPart& part : body.parts()) {
    const float first = part.world_from_local.translation().y() - part.shape.first_radius();
    const Eigen::Vector3f end = part.world_from_local * Eigen::Vector3f(0, part.shape.length(), 0);
    lowest = std::min({lowest, first, end.y() - part.shape.second_radius()});
  }
  return lowest;
}

TEST(WalkingBody, is_where_it_was_after_a_lap) {
  const auto start = WalkingBody::at(test_walk(), milliseconds(1300));
  const auto lap_later = WalkingBody::at(test_walk(), milliseconds(8300));
  ASSERT_EQ(start.parts().size(), lap_later.parts().size());
  for (std::size_t i = 0; i < start.parts().size(); ++i) {
    EXPECT_TRUE(start.parts()[i].world_from_local.isApprox(lap_later.parts()[i].world_from_local));
  }
}

TEST(WalkingBody, walks_before_time_zero_too) {
  const auto before = WalkingBody::at(test_walk(), milliseconds(-700));
  const auto after = WalkingBody::at(test_walk(), milliseconds(6300));
  EXPECT_TRUE(before.floor_point_m().isApprox(after.floor_point_m()));
}

TEST(WalkingBody, one_foot_always_touches_the_floor) {
  constexpr float kSole_m = 0.03F;  // a foot is made of balls: its sole is not a plane
  for (int i = 0; i < 70; ++i) {
    const auto body = WalkingBody::at(test_walk(), milliseconds(100 * i));
    EXPECT_NEAR(lowest_point_m(body), 0.0F, kSole_m) << "at " << 100 * i << " ms";
  }
}

TEST(WalkingBody, moves_at_walking_speed) {
  for (int i = 0; i < 14; ++i) {
    const auto now = WalkingBody::at(test_walk(), milliseconds(500 * i));
    const auto next = WalkingBody::at(test_walk(), milliseconds(500 * i + 100));
    const float speed = (next.floor_point_m() - now.floor_point_m()).norm() / 0.1F;
    EXPECT_GT(speed, 0.6F);
    EXPECT_LT(speed, 1.4F);
  }
}

TEST(WalkingBody, legs_swing_against_each_other_and_arms_against_legs) {
  const auto body = WalkingBody::at(test_walk(), milliseconds(350));  // a quarter of a stride
  const Eigen::Affine3f body_from_world = body.parts().front().local_from_world;
  float thigh_ahead[2] = {0, 0};
  int thighs = 0;
  for (const BodyPart& part : body.parts()) {
    const bool thigh = part.garment == Garment::kTrousers && part.shape.length() > 0.4F;
    if (!thigh) continue;
    const Eigen::Vector3f knee = part.world_from_local * Eigen::Vector3f(0, part.shape.length(), 0);
    thigh_ahead[thighs++] = (body_from_world * knee).z();
  }
  ASSERT_EQ(thighs, 2);
  EXPECT_GT(thigh_ahead[0], 0.1F);
  EXPECT_LT(thigh_ahead[1], -0.05F);
}

}  // namespace
}  // namespace roomcast::sim
