// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_hypotheses.h"

#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kFrom = corner_pose(2, 1.5), kTo = corner_pose(-2, -1.5);  // opposite

TEST(MovingHypotheses, a_walker_and_the_floor_tell_how_opposite_sensors_stand) {
  const auto a = walk_view({}, "a", kFrom), b = walk_view({}, "b", kTo);
  const auto found = hypotheses_by_motion(*a, *b);
  ASSERT_FALSE(found.empty());
  // Only a start: it must lie within the reach of the refinement that follows.
  const PoseDifference off = difference(found.front().a_from_b, kFrom.inverse() * kTo);
  EXPECT_LT(off.distance_m, MovingHypothesisOptions{}.coarse.reach_m);
  EXPECT_LT(off.angle_rad, 6 * std::numbers::pi / 180);
}

TEST(MovingHypotheses, none_where_nothing_moves) {
  const auto a = walk_view({}, "a", kFrom);
  SensorView still = *a;
  still.instants.clear();
  EXPECT_TRUE(hypotheses_by_motion(*a, still).empty());
}

TEST(MovingHypotheses, none_without_a_floor) {
  const auto a = walk_view({}, "a", kFrom), b = walk_view({}, "b", kTo);
  SensorView floorless = *b;
  floorless.floor.reset();
  EXPECT_TRUE(hypotheses_by_motion(*a, floorless).empty());
}

}  // namespace
}  // namespace roomcast::alignment
