// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pose_refinement.h"

#include <algorithm>

#include "roomcast/alignment/pair/feature_residuals.h"
#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {
namespace {

constexpr std::size_t kPoints = 1500;
constexpr int kSteps = 16;
constexpr float kReach_m = 0.12F, kMinReach_m = 0.05F, kShrink = 0.86F;
constexpr float kFeatureReach_m = 0.08F;
constexpr double kStill = 1e-4;  // radians and metres

PairVector step_of(const PairEquations& equations, const PairState& at, ColorCalibration color) {
  if (color == ColorCalibration::kUncertain) return solve_state(equations, at);
  PairVector step = PairVector::Zero();
  step.head<6>() = solve_motion(equations);
  return step;
}

}  // namespace

PairState refined_pose(const SensorView& a, const SensorView& b,
                       std::span<const PointMatch> matches, const RigidTransform& a_from_b,
                       ColorCalibration color) {
  const auto agreeing = agreeing_matches(matches, a_from_b, kFeatureReach_m);
  PairState state{a_from_b, {}, {}};
  float reach = kReach_m;
  for (int i = 0; i < kSteps; ++i) {
    PairEquations equations =
        surface_equations(surface_partners(a.surface, b.surface, state.a_from_b, {reach, kPoints}),
                          state.a_from_b, kUsualNoise);
    equations.add(
        feature_equations(a.picture, b.picture, state, agreeing, {kUsualFeatureSigma_px}));
    const PairVector step = step_of(equations, state, color);
    move(step, state);
    if (reach == kMinReach_m && step.head<6>().cwiseAbs().maxCoeff() < kStill) break;
    reach = std::max(kMinReach_m, kShrink * reach);
  }
  return state;
}

}  // namespace roomcast::alignment
