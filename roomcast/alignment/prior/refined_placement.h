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

namespace roomcast::alignment {

struct EstimatedPlacement {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;  // standard deviation, 2.5 m ahead of the sensor
};

/// Nothing if the sensor has next to no overlap with the placed sensors, if the overlap contradicts
/// the pose, or if the result differs from the estimate by more than 3 of its standard deviations.
[[nodiscard]] std::optional<EstimatedPlacement> refined_placement(
    const SensorView& view, const EstimatedPlacement& found, std::span<const PlacedView> placed);

}  // namespace roomcast::alignment
