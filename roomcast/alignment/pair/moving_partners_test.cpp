// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_partners.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kLeft = corner_pose(2, 1.5), kRight = corner_pose(-2, 1.5);

double mean_residual_m(const MovingPartners& found) {
  double sum = 0;
  for (const SurfacePartner& partner : found.partners) sum += std::abs(double(partner.residual_m));
  return found.partners.empty() ? 0 : sum / static_cast<double>(found.partners.size());
}

TEST(MovingPartners, lie_on_one_surface_at_the_true_pose) {
  const auto a = walk_view({}, "a", kLeft);
  const auto b = walk_view({}, "b", beside(kLeft, {0.3, 0, 0.2}, 0.1));
  const RigidTransform truth = kLeft.inverse() * beside(kLeft, {0.3, 0, 0.2}, 0.1);
  const MovingPartners found = moving_partners(*a, 1, *b, 1, truth, 0.2F);
  ASSERT_GT(found.partners.size(), 100u);
  EXPECT_GT(found.independent, 50);
  EXPECT_LT(mean_residual_m(found), 0.01);
}

TEST(MovingPartners, a_wrong_scale_moves_them_apart) {
  const auto a = walk_view({}, "a", kLeft);
  const auto b = walk_view({}, "b", beside(kLeft, {0.3, 0, 0.2}, 0.1));
  const RigidTransform truth = kLeft.inverse() * beside(kLeft, {0.3, 0, 0.2}, 0.1);
  const MovingPartners found = moving_partners(*a, 1, *b, 1.04, truth, 0.2F);
  ASSERT_GT(found.partners.size(), 50u);
  EXPECT_GT(mean_residual_m(found), 0.03);  // 4 % of about 2 m, on slanted surfaces less
}

TEST(MovingPartners, none_where_nothing_moves) {
  const auto a = walk_view({}, "a", kLeft), b = walk_view({}, "b", kRight);
  SensorView still = *b;
  still.instants.clear();
  EXPECT_TRUE(moving_partners(*a, 1, still, 1, kLeft.inverse() * kRight, 0.2F).partners.empty());
}

}  // namespace
}  // namespace roomcast::alignment
