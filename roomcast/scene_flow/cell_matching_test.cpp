// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/cell_matching.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::scene_flow {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr float kWay = 30;  // for things at 2 m: 15 cells

/// A round thing of 8 cells radius, nearest in its middle.
CellDepths ball_at(float center_x, float center_y, float depth_mm = 2000) {
  CellDepths cells(kWidth, kHeight);
  constexpr float kRadius = 8;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float dx = static_cast<float>(x) - center_x, dy = static_cast<float>(y) - center_y;
      const float inside = kRadius * kRadius - dx * dx - dy * dy;
      if (inside > 0) cells.at(x, y) = static_cast<std::int16_t>(depth_mm - 20 * std::sqrt(inside));
    }
  }
  return cells;
}

Displacement center_of(const CellDepths& newest, const CellDepths& earlier) {
  CellMatcher matcher;
  return matcher.match(newest, earlier, kWay).at(kWidth / 2, kHeight / 2);
}

TEST(CellMatcher, what_stands_still_has_not_moved) {
  const CellDepths ball = ball_at(32, 24);
  const Displacement by = center_of(ball, ball);
  EXPECT_NEAR(by.x, 0, 1e-3);
  EXPECT_NEAR(by.y, 0, 1e-3);
  EXPECT_EQ(by.farther_mm, 0);
}

TEST(CellMatcher, finds_where_a_thing_was) {
  const Displacement by = center_of(ball_at(32, 24), ball_at(27, 26));
  EXPECT_NEAR(by.x, -5, 0.1);
  EXPECT_NEAR(by.y, 2, 0.1);
  EXPECT_NEAR(by.farther_mm, 0, 1);
}

TEST(CellMatcher, finds_ways_of_up_to_the_longest) {
  EXPECT_NEAR(center_of(ball_at(32, 24), ball_at(17, 24)).x, -15, 0.2);
}

TEST(CellMatcher, finds_parts_of_a_cell) {
  EXPECT_NEAR(center_of(ball_at(32, 24), ball_at(30.6F, 24)).x, -1.4, 0.25);
}

TEST(CellMatcher, tells_nearing_from_moving_beside) {
  const Displacement by = center_of(ball_at(32, 24, 2000), ball_at(30, 24, 2080));
  EXPECT_NEAR(by.x, -2, 0.2);
  EXPECT_NEAR(by.farther_mm, 80, 5);
}

TEST(CellMatcher, two_things_move_apart) {
  CellDepths newest = ball_at(14, 24), earlier = ball_at(11, 24);
  const CellDepths right_now = ball_at(48, 24), right_then = ball_at(50, 24);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 30; x < kWidth; ++x) {
      newest.at(x, y) = right_now.at(x, y);
      earlier.at(x, y) = right_then.at(x, y);
    }
  }
  CellMatcher matcher;
  const Image<Displacement>& by = matcher.match(newest, earlier, kWay);
  EXPECT_NEAR(by.at(14, 24).x, -3, 0.2);
  EXPECT_NEAR(by.at(48, 24).x, 2, 0.2);
}

TEST(CellMatcher, a_picture_without_a_foreground_is_no_fault) {
  CellMatcher matcher;
  const Image<Displacement>& by = matcher.match(ball_at(32, 24), CellDepths(kWidth, kHeight), kWay);
  EXPECT_EQ(by.at(32, 24).farther_mm, 0);
}

TEST(CellMatcher, the_smallest_pictures_are_no_fault) {
  CellMatcher matcher;
  const CellDepths one(1, 1, 1000);
  EXPECT_EQ(matcher.match(one, one, kWay).at(0, 0).x, 0);
  EXPECT_EQ(matcher.match(CellDepths(), CellDepths(), kWay).width(), 0);
}

}  // namespace
}  // namespace roomcast::scene_flow
