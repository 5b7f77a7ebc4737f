// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_hypotheses.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kFrom = corner_pose(2, 1.5), kTo = corner_pose(-2, -1.5);  // opposite

TEST(MovingHypotheses, a_walker_and_the_floor_tell_how_opposite_sensors_stand) {
  const auto a = walk_view({}, "a", kFrom), b = walk_view({}, "b", kTo);
  const auto found = hypotheses_by_motion(*a, *b);
  const RigidTransform truth = kFrom.inverse() * kTo;
  EXPECT_TRUE(std::ranges::any_of(
      found, [&](const PoseHypothesis& each) { return !are_rivals(each.a_from_b, truth); }));
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
