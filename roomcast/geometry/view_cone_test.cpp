// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/view_cone.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Ahead of an eye at (1, 2, 3) that looks along -z: a direction turned to the right, then up.
Eigen::Vector3f turned(float right_rad, float up_rad, float distance_m = 2) {
  return distance_m * Eigen::Vector3f(std::sin(right_rad) * std::cos(up_rad), std::sin(up_rad),
                                      -std::cos(right_rad) * std::cos(up_rad));
}

ViewCone view(const ViewAngles& angles) {
  return {{1, 2, 3}, -Eigen::Vector3f::UnitZ(), angles, Eigen::Vector3f::UnitY()};
}

TEST(ViewCone, a_round_view_reaches_equally_far_in_all_directions) {
  const ViewBounds bounds(view({.half_angle_rad = 0.5}));
  for (const float sign : {-1.0F, 1.0F}) {
    EXPECT_LE(bounds.distance_outside(turned(sign * 0.49F, 0)), 0);
    EXPECT_LE(bounds.distance_outside(turned(0, sign * 0.49F)), 0);
    EXPECT_GT(bounds.distance_outside(turned(sign * 0.51F, 0)), 0);
    EXPECT_GT(bounds.distance_outside(turned(0, sign * 0.51F)), 0);
  }
}

TEST(ViewCone, a_picture_bounds_a_view_at_its_sides) {
  const ViewBounds bounds(
      view({.half_angle_rad = 0.9, .half_width_rad = 0.8, .half_height_rad = 0.5}));
  EXPECT_LE(bounds.distance_outside(turned(0.79F, 0)), 0);
  EXPECT_GT(bounds.distance_outside(turned(0.81F, 0)), 0);
  EXPECT_LE(bounds.distance_outside(turned(0, -0.49F)), 0);
  EXPECT_GT(bounds.distance_outside(turned(0, -0.51F)), 0) << "within the round view";
}

TEST(ViewCone, a_view_without_an_upward_direction_is_round) {
  ViewCone cone = view({.half_angle_rad = 0.9, .half_width_rad = 0.8, .half_height_rad = 0.5});
  cone.up.setZero();
  EXPECT_LE(ViewBounds(cone).distance_outside(turned(0, 0.85F)), 0);
}

TEST(ViewCone, outside_is_told_in_metres) {
  const ViewBounds bounds(
      view({.half_angle_rad = 1.2, .half_width_rad = 0.5, .half_height_rad = 0.5}));
  EXPECT_NEAR(bounds.distance_outside(turned(0.7F, 0, 2)), 2 * std::sin(0.2F), 1e-5);
}

TEST(ViewCone, a_margin_widens_all_angles) {
  const ViewCone cone =
      view({.half_angle_rad = 0.9, .half_width_rad = 0.8, .half_height_rad = 0.5});
  EXPECT_LE(ViewBounds(cone, 0.2F).distance_outside(turned(0, 0.69F)), 0);
  EXPECT_GT(ViewBounds(cone, 0.2F).distance_outside(turned(0, 0.71F)), 0);
}

TEST(ViewCone, a_view_wider_than_half_the_surroundings_sees_behind_itself) {
  const ViewBounds wide(view({.half_angle_rad = 2, .half_width_rad = 2, .half_height_rad = 2}));
  EXPECT_LE(wide.distance_outside(turned(1.9F, 0)), 0);
  EXPECT_LE(wide.distance_outside(turned(kPi, 1.2F)), 0) << "above and behind";
  EXPECT_GT(wide.distance_outside(turned(2.1F, 0)), 0);
  EXPECT_GT(wide.distance_outside(turned(kPi, 0)), 0);
  EXPECT_LE(ViewBounds(view({.half_angle_rad = kPi}), 1).distance_outside(turned(kPi, 0)), 1e-5F);
}

}  // namespace
}  // namespace roomcast
