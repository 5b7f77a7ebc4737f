// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_partners.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kLeft = corner_pose(2, 1.5), kRight = beside(kLeft, {0.3, 0, 0.2}, 0.1);

double mean_residual_m(const MovingPartners& found) {
  double sum = 0;
  for (const SurfacePartner& partner : found.partners) sum += std::abs(double(partner.residual_m));
  return found.partners.empty() ? 0 : sum / static_cast<double>(found.partners.size());
}

MovingPartners partners_with(double scale_of_b) {
  const auto a = walk_view({}, "a", kLeft), b = walk_view({}, "b", kRight);
  const auto of_a = moving_surfaces(*a), of_b = moving_surfaces(*b);
  return moving_partners({a->surface.lens, of_a, 1}, {b->surface.lens, of_b, scale_of_b},
                         kLeft.inverse() * kRight, 0.2F);
}

TEST(MovingPartners, lie_on_one_surface_at_the_true_pose) {
  const MovingPartners found = partners_with(1);
  ASSERT_GT(found.partners.size(), 100u);
  EXPECT_GT(found.instants, 4u);
  EXPECT_LE(found.instants, std::size_t(kWalkInstants));
  EXPECT_LT(mean_residual_m(found), 0.01);
}

TEST(MovingPartners, a_wrong_scale_moves_them_apart) {
  const MovingPartners found = partners_with(1.04);
  ASSERT_GT(found.partners.size(), 50u);
  EXPECT_GT(mean_residual_m(found), 0.03);  // 4 % of about 2 m, on slanted surfaces less
}

TEST(MovingPartners, none_where_nothing_moves) {
  const auto a = walk_view({}, "a", kLeft), b = walk_view({}, "b", kRight);
  const auto of_a = moving_surfaces(*a);
  const MovingPartners found = moving_partners({a->surface.lens, of_a}, {b->surface.lens, {}},
                                               kLeft.inverse() * kRight, 0.2F);
  EXPECT_TRUE(found.partners.empty());
  EXPECT_EQ(found.instants, 0u);
}

}  // namespace
}  // namespace roomcast::alignment
