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
#include "roomcast/alignment/rig/pose_selection.h"

namespace roomcast::alignment {

struct RefinedSensor {
  RigidTransform origin_from_sensor;
  SensorCorrection correction;
  /// Covariance of (rotation, shift) in the origin's frame, from the equations; 0 for the origin
  /// and for sensors that no pair constrains.
  Matrix6 covariance = Matrix6::Zero();
};

/// `pairs` are the accepted pairs; sensors in none of them do not move.
[[nodiscard]] std::vector<RefinedSensor> refine_rig(
    std::span<const RigidTransform> origin_from_sensor, std::size_t origin,
    std::span<const RigPair> pairs);

}  // namespace roomcast::alignment
