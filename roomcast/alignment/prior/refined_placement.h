// SPDX-License-Identifier: Apache-2.0
// Refines a pose that was estimated from a person's walk. (A pose from a board is more exact than
// the overlap of the sensors and is not refined.) Most sensors that face each other share some
// surfaces, such as the floor or table tops, but too few or too ambiguous ones to find the pose by.
// Near the estimated pose they determine it more exactly. The result is the mean of both, weighted
// by their information (weighted least squares): in directions that the shared surfaces leave open,
// as on a bare floor, the estimate stays unchanged. Metres. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/prior/prior_evidence.h"
#include "roomcast/alignment/rig/placed_rig.h"

namespace roomcast::alignment {

struct RefinedPlacementOptions {
  double walk_radius_m = 1;  // the lever for a walk's rotation; by hand
  double max_sigmas = 3;     // of the estimate, from it to the refined pose (ADR 14)
  PriorEvidenceOptions evidence;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("walk_radius_m", walk_radius_m, Range{0.01, 100});
    visit("max_sigmas", max_sigmas, Range{0.1, 100});
    visit("evidence", evidence);
  }
  [[nodiscard]] Status check() const { return check_fields("RefinedPlacementOptions", *this); }
};

struct EstimatedPlacement {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;  // standard deviation, 2.5 m ahead of the sensor
};

/// Nothing if the sensor has next to no overlap with the placed sensors, if the overlap contradicts
/// the pose, or if the result is too many of the estimate's standard deviations from it.
[[nodiscard]] std::optional<EstimatedPlacement> refined_placement(
    const SensorView& view, const EstimatedPlacement& found, std::span<const PlacedView> placed,
    const RefinedPlacementOptions& options = {}, const RigOptions& rig = {});

}  // namespace roomcast::alignment
