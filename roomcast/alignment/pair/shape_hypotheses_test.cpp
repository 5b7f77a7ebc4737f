// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/shape_hypotheses.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const ViewFixture& beside() {
  static const ViewFixture view =
      view_fixture({}, "beside", world_from_optical_looking_at({1.2, 1.9, 1.6}, {-0.3, 0.4, -0.3}));
  return view;
}

TEST(ShapeHypotheses, hold_the_true_pose_without_any_colour) {
  const auto found = hypotheses_by_shape(first_corner().view->surface, beside().view->surface);
  const RigidTransform truth = true_pose(first_corner(), beside());
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const PoseHypothesis& hypothesis) {
    const auto apart = difference(hypothesis.a_from_b, truth);
    return apart.angle_rad < 0.1 && apart.distance_m < 0.15;
  }));
}

}  // namespace
}  // namespace roomcast::alignment
