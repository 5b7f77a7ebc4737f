// SPDX-License-Identifier: Apache-2.0
// Verifies a prior pose that a person proposes for a sensor. The pose is refined, from the prior
// and from poses around it, on the surfaces that the sensor shares with others
// (pair/pose_refinement.h). The refined poses are scored by free space, colours and features like
// any other hypothesis (PairCandidates::examine). Because of the prior, less support is required
// than in alignment without one; but no evidence may contradict the pose, and no other pose near
// the prior may fit equally well. Metres. Thread-safe (no state).
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
  std::string beside;  // the placed sensor that it was verified against
};

/// kUnavailable: the prior is rejected; the message gives the reason and what would help.
[[nodiscard]] Result<NudgedPose> refined_prior(const SensorView& view,
                                               const RigidTransform& prior_world_from_depth,
                                               std::span<const PlacedView> others);

/// As above, for one pair of sensors, where the pose of `a` is known. The prior is varied along the
/// floor and about the vertical. The error comes from the surfaces that both see.
[[nodiscard]] Result<NudgedPose> refined_prior(const PairCandidates& pair,
                                               const RigidTransform& world_from_a,
                                               const RigidTransform& prior_world_from_b);

}  // namespace roomcast::alignment
