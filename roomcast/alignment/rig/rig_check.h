// SPDX-License-Identifier: Apache-2.0
// Checks whether a refined answer can be true, against all that its sensors see of one another,
// also where no feature was found: surfaces that one sensor sees and another looks through, and
// differing texture on walls and floors. This detects poses that fit only by a floor's pattern.
// Single-threaded.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/alignment/rig/pose_selection.h"
#include "roomcast/alignment/rig/rig_refinement.h"

namespace roomcast::alignment {

/// A refined answer: which sensors are placed, and where.
struct RigAnswer {
  PoseSelection selection;
  std::vector<bool> placed;
  std::vector<RefinedSensor> refined;

  [[nodiscard]] RigidTransform relative(const RigPair& pair) const {
    return refined[pair.first].origin_from_sensor.inverse() *
           refined[pair.second].origin_from_sensor;
  }
  [[nodiscard]] PairState state(const RigPair& pair) const {
    return {relative(pair), refined[pair.first].correction, refined[pair.second].correction};
  }
};

/// Checks successive answers for the same sensors.
class RigCheck {
 public:
  /// The sensor whose refined pose contradicts the views of all others most; nothing if none does.
  /// Of equals, one that is not the origin, then the one with the smaller margin.
  [[nodiscard]] std::optional<std::size_t> contradicted_sensor(std::span<const RigPair> pairs,
                                                               const RigAnswer& answer);

 private:
  std::vector<bool> exact_colors_;  // sensors whose colours agreed with another's in any check
};

}  // namespace roomcast::alignment
