// SPDX-License-Identifier: Apache-2.0
// What becomes of a person's guess where a sensor stands. From the guess and from a little beside
// it the pose settles on the surfaces that the sensor shares with others (pair/pose_refinement.h);
// what it ends up as is judged by free space, colours and features like any other hypothesis
// (PairCandidates::examine). The guess stands for what alignment lacks by itself, so less support
// is asked for, but nothing may contradict the pose, and no other place near the guess may fit as
// well. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <string>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/prior/prior_evidence.h"
#include "roomcast/core/result.h"

namespace roomcast::alignment {

struct NudgedPose {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;
  std::string beside;  // the sensor that it was held against
};

/// kUnavailable: why the guess is not taken, and what would help.
[[nodiscard]] Result<NudgedPose> refined_prior(const SensorView& view,
                                               const RigidTransform& prior_world_from_depth,
                                               std::span<const PlacedView> others);

/// Of two sensors alone, `a` where it is known to stand: beside the guess is along the floor, and
/// turned about the vertical. The error is of what both see.
[[nodiscard]] Result<NudgedPose> refined_prior(const PairCandidates& pair,
                                               const RigidTransform& world_from_a,
                                               const RigidTransform& prior_world_from_b);

}  // namespace roomcast::alignment
