// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pose_refinement.h"

#include <algorithm>

#include "roomcast/alignment/pair/match_support.h"

namespace roomcast::alignment {
namespace {

PairVector step_of(const PairEquations& equations, const PairState& at, ColorCalibration color,
                   const ColorShiftOptions& shift) {
  if (color == ColorCalibration::kUncertain) return solve_state(equations, at, shift);
  PairVector step = PairVector::Zero();
  step.head<6>() = solve_motion(equations);
  return step;
}

}  // namespace

PairState refined_pose(const SensorView& a, const SensorView& b,
                       std::span<const PointMatch> matches, const RigidTransform& a_from_b,
                       ColorCalibration color, const PoseRefinementOptions& options,
                       const ResidualOptions& residuals) {
  const auto agreeing = agreeing_matches(matches, a_from_b, options.feature_reach_m);
  PairState state{a_from_b, {}, {}};
  float reach = options.reach_m;
  for (int i = 0; i < options.max_steps; ++i) {
    PairEquations equations =
        surface_equations(surface_partners(a.surface, b.surface, state.a_from_b,
                                           {reach, options.points}, residuals.surfaces),
                          state.a_from_b, options.surface_noise, residuals.surfaces);
    equations.add(feature_equations(a.picture, b.picture, state, agreeing,
                                    {options.feature_sigma_px}, residuals.features));
    const PairVector step = step_of(equations, state, color, residuals.color_shift);
    move(step, state);
    if (reach == options.min_reach_m && step.head<6>().cwiseAbs().maxCoeff() < options.still) break;
    reach = std::max(options.min_reach_m, options.shrink * reach);
  }
  return state;
}

}  // namespace roomcast::alignment
