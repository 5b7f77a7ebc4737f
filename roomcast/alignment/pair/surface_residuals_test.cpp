// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/surface_residuals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/wall_fixture.h"
#include "roomcast/alignment/view/depth_noise.h"

namespace roomcast::alignment {
namespace {

constexpr double kAhead_m = 2;
constexpr float kSinglePrecision_m = 1e-5F;

RigidTransform pose_too_far(double z_m) {
  RigidTransform a_from_b;
  a_from_b.translation_m.z() = z_m;
  return a_from_b;
}

std::vector<SurfacePartner> wall_partners(const RigidTransform& a_from_b,
                                          const SurfaceReach& reach = {}) {
  const DepthSurface wall = wall_surface(wall_depth(kAhead_m));
  return surface_partners(wall, wall, a_from_b, reach);
}

TEST(SurfacePartners, of_a_wall_too_far_away_are_that_far_apart) {
  const auto partners = wall_partners(pose_too_far(0.03));
  ASSERT_FALSE(partners.empty());
  const float sigma_m = depth_sigma_m(float(kAhead_m));
  for (const SurfacePartner& partner : partners) {
    EXPECT_NEAR(partner.normal.z(), -1, 1e-5);
    EXPECT_NEAR(partner.residual_m, -0.03F, kSinglePrecision_m);  // against the normal
    EXPECT_NEAR(partner.a_m.z(), kAhead_m, kSinglePrecision_m);
    EXPECT_NEAR(partner.b_m.z(), kAhead_m, kSinglePrecision_m);
    EXPECT_NEAR(partner.variance_m2, sigma_m * sigma_m, 1e-9F);
  }
}

TEST(SurfacePartners, are_looked_up_both_ways) {
  // Every sample of either view has a partner at the true pose: at the same pixel of the other.
  const DepthSurface wall = wall_surface(wall_depth(kAhead_m));
  EXPECT_EQ(surface_partners(wall, wall, {}, {}).size(), 2 * wall.samples.size());
}

TEST(SurfacePartners, out_of_reach_are_none) {
  EXPECT_TRUE(wall_partners(pose_too_far(0.06), {.reach_m = 0.05F}).empty());
  EXPECT_FALSE(wall_partners(pose_too_far(0.04), {.reach_m = 0.05F}).empty());
}

TEST(SurfacePartners, that_face_away_from_each_other_are_none) {
  RigidTransform from_behind = pose_too_far(2 * kAhead_m);
  from_behind.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  EXPECT_TRUE(wall_partners(from_behind).empty());
}

TEST(SurfacePartners, are_about_as_many_as_asked_for) {
  // About 3300 samples of each view: one in three of them for 1000.
  const double all = double(wall_partners({}).size());
  EXPECT_NEAR(double(wall_partners({}, {.points = 1000}).size()), all / 3, 3);
}

TEST(SurfaceEquations, solve_the_distance_of_two_walls) {
  const RigidTransform start = pose_too_far(0.03);
  const PairEquations equations = surface_equations(wall_partners(start), start, 3);
  const Vector6 step = solve_motion(equations);
  EXPECT_NEAR(step(5), -0.03, 1e-4);
  EXPECT_LT(std::abs(step(3)) + std::abs(step(4)), 1e-4);  // a wall says nothing along itself
  EXPECT_LT(step.head<3>().norm(), 1e-4);
}

TEST(SurfaceEquations, colour_shifts_do_not_affect_surfaces) {
  const PairEquations equations = surface_equations(wall_partners({}), {}, 1);
  for (const Eigen::Index shift : {kOfA + kShift, kOfB + kShift}) {
    EXPECT_TRUE(equations.information.middleCols<2>(shift).isZero());
    EXPECT_TRUE(equations.information.middleRows<2>(shift).isZero());
  }
}

TEST(SurfaceEquations, count_as_no_more_than_1500_independent_partners) {
  const auto partners = wall_partners({});
  ASSERT_GT(partners.size(), 6000u);
  const float sigma_m = depth_sigma_m(float(kAhead_m));
  // Each partner gives 1 / sigma^2 on the distance, at the pose where all residuals are zero.
  EXPECT_NEAR(surface_equations(partners, {}, 1).information(5, 5),
              1500 / double(sigma_m * sigma_m), 1500);
  const std::span<const SurfacePartner> few(partners.data(), 100);
  EXPECT_NEAR(surface_equations(few, {}, 1).information(5, 5), 100 / double(sigma_m * sigma_m),
              100);
  EXPECT_NEAR(surface_equations(few, {}, 2).information(5, 5), 100 / double(4 * sigma_m * sigma_m),
              100);
  EXPECT_EQ(surface_equations(few, {}, 1).terms, 100);
}

TEST(SurfaceScores, sum_up_to_the_gradient) {
  const RigidTransform start = pose_too_far(0.02);
  const auto partners = wall_partners(start);
  PairScores scores;
  add_surface_scores(partners, start, 1, scores);
  PairVector sum = PairVector::Zero();
  double weight = 0, residual = 0;
  for (const auto& [patch, of_patch] : scores.of_a) {
    sum += of_patch.score;
    weight += of_patch.weight;
    residual += of_patch.residual;
  }
  const PairVector gradient = surface_equations(partners, start, 1).gradient;
  EXPECT_LT((sum - gradient).norm(), 1e-9 * gradient.norm());
  EXPECT_NEAR(residual / weight, -0.02, 1e-5);
}

/// Partners with these residuals and a standard deviation of 1 cm.
std::vector<SurfacePartner> partners_with(const std::vector<float>& residuals_m) {
  std::vector<SurfacePartner> partners;
  for (const float residual_m : residuals_m)
    partners.push_back({{0, 0, 2}, {0, 0, 2}, {0, 0, -1}, residual_m, 1e-4F});
  return partners;
}

TEST(SurfaceNoise, is_that_of_the_median_residual) {
  // The median of a normal distribution's absolute values is 0.6745 sigmas.
  EXPECT_NEAR(surface_noise(partners_with({0.1F, -0.006745F, 0, 0.0001F, -0.5F})), 1, 1e-5);
  EXPECT_NEAR(surface_noise(partners_with({0.0033725F})), 0.5, 1e-5);
}

TEST(SurfaceNoise, stays_within_reason) {
  EXPECT_DOUBLE_EQ(surface_noise(partners_with({0})), 0.2);
  EXPECT_DOUBLE_EQ(surface_noise(partners_with({0.05F})), 1.5);
  EXPECT_DOUBLE_EQ(surface_noise({}), 1.5);
}

}  // namespace
}  // namespace roomcast::alignment
