// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/nudged_pose.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::alignment {
namespace {

Result<NudgedPose> answer(const RigidTransform& guess) {
  const std::array others = {
      PlacedView{first_corner().view.get(), first_corner().world_from_depth}};
  return refined_prior(*second_corner().view, guess, others);
}

TEST(NudgedPose, a_guess_nearby_is_refined) {
  const RigidTransform truth = second_corner().world_from_depth;
  const auto found = answer(beside(truth, {0.12, 0.03, -0.08}, 0.06));
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_LT((found->world_from_depth.translation_m - truth.translation_m).norm(), 0.02);
  EXPECT_GT(found->expected_error_mm, 0);
  EXPECT_LT(found->expected_error_mm, 30);
}

TEST(NudgedPose, a_guess_far_off_is_refused_with_a_reason) {
  const auto found = answer(beside(second_corner().world_from_depth, {1.2, 0, 0.9}, 1.3));
  ASSERT_FALSE(found.ok());
  EXPECT_FALSE(found.error().message.empty());
}

TEST(NudgedPose, where_nothing_is_shared_nothing_can_be_said) {
  const auto found = answer(beside(second_corner().world_from_depth, {40, 0, 0}, 0));
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("no overlap"), std::string::npos);
}

TEST(NudgedPose, without_placed_sensors_it_is_refused) {
  EXPECT_FALSE(refined_prior(*first_corner().view, {}, {}));
}

}  // namespace
}  // namespace roomcast::alignment
