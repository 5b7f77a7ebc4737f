// SPDX-License-Identifier: Apache-2.0
// Joint refinement: Gauss-Newton over the poses and calibration corrections of all sensors at once,
// on the surfaces and features that any two of them share. Poses are updated by a small motion in
// the origin's frame (Lie algebra of SE(3)), so a pair's equations are transformed by its adjoint.
// Metres, radians, pixels. Single-threaded, deterministic.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/rig/pose_selection.h"

namespace roomcast::alignment {

struct RefinedSensor {
  RigidTransform origin_from_sensor;
  SensorCorrection correction;
  /// Covariance of (rotation, shift) in the origin's frame, from the equations; 0 for the origin
  /// and for sensors that no pair constrains. The first is what is said of the pose, the second
  /// weighs it against another estimate (DepthUncertainty).
  Matrix6 covariance = Matrix6::Zero(), weighed_covariance = Matrix6::Zero();
  double uncalibrated_belief = 0;  // that the rig's sensors are not calibrated (DepthUncertainty)
};

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct RigRefinementOptions {
  int max_steps = 16;
  std::size_t points = 8000;  // surface points of each view of a pair
  /// Partners are sought within reach_m, which shrinks from step to step, down to min_reach_m.
  float reach_m = 0.08F, min_reach_m = 0.03F, shrink = 0.75F;
  float feature_reach_m = 0.08F;  // of matches that take part
  /// Features are located to a quarter of a pixel, but errors of neighbouring features are
  /// correlated, through remaining errors of calibration and depth. However many features there
  /// are, they count as no more than so many independent ones (ADR 13).
  double independent_features = 30;
  double still = 3e-5;  // a smaller step, metres and radians, is the last
  /// A refined answer with less than these shares of its score, its matches and its common surface
  /// has slid and is given up (ADR 11).
  double min_evidence_kept = 0.5, min_matches_kept = 0.5, min_common_kept = 0.95;
  PatchOptions patches;
  DepthUncertainty depth_uncertainty;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_steps", max_steps, Range{0, 1000});
    visit("points", points, Range{1, 1e6});
    visit("reach_m", reach_m, Range{0.001, 10});
    visit("min_reach_m", min_reach_m, Range{0.001, 10});
    visit("shrink", shrink, Range{0, 1});
    visit("feature_reach_m", feature_reach_m, Range{0.001, 10});
    visit("independent_features", independent_features, Range{1, 1e6});
    visit("still", still, Range{0, 1});
    visit("min_evidence_kept", min_evidence_kept, Range{0, 1});
    visit("min_matches_kept", min_matches_kept, Range{0, 1});
    visit("min_common_kept", min_common_kept, Range{0, 1});
    visit("patches", patches);
    visit("depth_uncertainty", depth_uncertainty);
  }
  [[nodiscard]] Status check() const {
    if (Status status = check_fields("RigRefinementOptions", *this); !status) return status;
    return check_at_most("RigRefinementOptions", "min_reach_m", double(min_reach_m), "reach_m",
                         double(reach_m));
  }
};

/// `pairs` are the accepted pairs; sensors in none of them do not move.
[[nodiscard]] std::vector<RefinedSensor> refine_rig(
    std::span<const RigidTransform> origin_from_sensor, std::size_t origin,
    std::span<const RigPair> pairs, const RigRefinementOptions& options = {},
    const ResidualOptions& residuals = {});

}  // namespace roomcast::alignment
