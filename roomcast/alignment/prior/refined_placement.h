// SPDX-License-Identifier: Apache-2.0
// What becomes of a place that was found by something other than what sensors share: somebody's
// walk. (A board tells more exactly than what is shared.) Most sensors across from each other do
// share something, a floor, the tops of tables, only too little or too much alike to find the place
// by. Near it, it says more exactly where the sensor stands. Both are put together, each by how
// exactly it tells (weighted least squares), so that along what is shared, as on a bare floor, the
// place stays as it was found. Metres. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/prior/prior_evidence.h"

namespace roomcast::alignment {

struct EstimatedPlacement {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;  // standard deviation, 2.5 m ahead of the sensor
};

/// Nothing where the sensor shares next to nothing with those that are placed, where what they
/// share contradicts the place, or where it says something else than what found it.
[[nodiscard]] std::optional<EstimatedPlacement> refined_placement(
    const SensorView& view, const EstimatedPlacement& found, std::span<const PlacedView> placed);

}  // namespace roomcast::alignment
