// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/round_cone.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

constexpr float kTolerance_m = 2e-5F;

/// Distance to the hull by its definition: the smallest distance to any of the balls between the
/// two.
float distance_by_definition(const Vector3f& point, float first, float second, float length) {
  float least = INFINITY;
  for (int i = 0; i <= 20000; ++i) {
    const float share = static_cast<float>(i) / 20000.0F;
    const Vector3f centre(0, share * length, 0);
    least = std::min(least, (point - centre).norm() - std::lerp(first, second, share));
  }
  return least;
}

TEST(RoundCone, ray_along_the_axis_meets_the_ball_at_the_end) {
  const RoundCone shape(0.2F, 0.1F, 1.0F);
  const auto t = shape.entry({0, 3, 0}, {0, -1, 0});
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t, 3.0F - 1.1F, kTolerance_m);
}

TEST(RoundCone, length_of_the_direction_scales_t) {
  const RoundCone shape(0.2F, 0.2F, 1.0F);
  const auto t = shape.entry({-2, 0.5F, 0}, {0.5F, 0, 0});
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t, 1.8F / 0.5F, kTolerance_m);
}

TEST(RoundCone, rays_that_pass_beside_it_meet_nothing) {
  const RoundCone shape(0.2F, 0.1F, 1.0F);
  EXPECT_FALSE(shape.entry({-2, 0.5F, 0.21F}, {1, 0, 0}));
  EXPECT_FALSE(shape.entry({-2, 1.11F, 0}, {1, 0, 0}));
  EXPECT_FALSE(shape.entry({-2, 0.5F, 0}, {-1, 0, 0}));  // behind the origin
}

TEST(RoundCone, every_entry_lies_on_the_hull_of_the_balls) {
  const RoundCone shape(0.25F, 0.08F, 0.6F);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    const float angle = 0.37F * static_cast<float>(i);
    const Vector3f origin(2.0F * std::cos(angle), 0.3F + std::sin(3.0F * angle),
                          2.0F * std::sin(angle));
    const Vector3f target(0.1F * std::sin(5.0F * angle), 0.02F * static_cast<float>(i), 0);
    const Vector3f direction = target - origin;
    const auto t = shape.entry(origin, direction);
    if (!t) continue;
    ++met;
    const Vector3f point = origin + *t * direction;
    EXPECT_NEAR(distance_by_definition(point, 0.25F, 0.08F, 0.6F), 0.0F, kTolerance_m);
    EXPECT_LT(shape.normal_at(point).dot(direction), 0.0F);
  }
  EXPECT_GT(met, 30);
}

}  // namespace
}  // namespace roomcast::sim
