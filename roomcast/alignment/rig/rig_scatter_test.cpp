// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_scatter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {
namespace {

/// The view of the second corner with the left half of its depth `bias_m` too far.
std::shared_ptr<const SensorView> biased_view(double bias_m) {
  CalibrationBundle bundle = bundle_fixture({}, "s1", second_corner().world_from_depth);
  for (int y = 0; y < bundle.depth_mm.height(); ++y) {
    for (int x = 0; x < bundle.depth_mm.width() / 2; ++x)
      bundle.depth_mm.at(x, y) += static_cast<std::uint16_t>(std::lround(1000 * bias_m));
  }
  auto view = make_sensor_view(bundle);
  ROOMCAST_ASSERT(view.ok());
  return std::make_shared<const SensorView>(std::move(*view));
}

std::vector<SurfacePartner> partners_of(const SensorView& second) {
  return surface_partners(first_corner().view->surface, second.surface,
                          true_pose(first_corner(), second_corner()), {0.05F, 6000});
}

RigScatter scatter_of(const SensorView& second) {
  PairScores scores;
  add_surface_scores(partners_of(second), true_pose(first_corner(), second_corner()), kUsualNoise,
                     scores);
  RigScatter scatter(2);
  scatter.add(0, 1, {}, scores);
  return scatter;
}

TEST(PairScores, add_up_to_the_gradient_by_either_sensors_patches) {
  const auto view = biased_view(0.02);
  const auto partners = partners_of(*view);
  const RigidTransform a_from_b = true_pose(first_corner(), second_corner());
  PairScores scores;
  add_surface_scores(partners, a_from_b, kUsualNoise, scores);
  PairVector by_a = PairVector::Zero(), by_b = PairVector::Zero();
  for (const auto& [patch, of_patch] : scores.of_a) by_a += of_patch.score;
  for (const auto& [patch, of_patch] : scores.of_b) by_b += of_patch.score;
  const PairVector gradient = surface_equations(partners, a_from_b, kUsualNoise).gradient;
  EXPECT_GT(scores.of_a.size(), 4u);
  EXPECT_LT((by_a - gradient).norm(), 1e-6 * gradient.norm());
  EXPECT_LT((by_b - gradient).norm(), 1e-6 * gradient.norm());
}

TEST(RigScatter, finds_out_by_how_much_surfaces_disagree_smoothly) {
  const double exact_m = scatter_of(*second_corner().view).disagreement_m();
  const double biased_m = scatter_of(*biased_view(0.012)).disagreement_m();
  EXPECT_LT(exact_m, 0.002);
  EXPECT_GT(biased_m, 0.003);
  EXPECT_LT(biased_m, 0.012);
}

TEST(RigScatter, smooth_errors_make_poses_doubtful) {
  EXPECT_GT(scatter_of(*biased_view(0.012)).variance().trace(),
            3 * scatter_of(*second_corner().view).variance().trace());
}

}  // namespace
}  // namespace roomcast::alignment
