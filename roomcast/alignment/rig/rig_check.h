// SPDX-License-Identifier: Apache-2.0
// Can an answer be true? Once refined it is held against everything that its sensors see of one
// another, also where no feature was found: surfaces that one sees and another looks through, and
// prints on walls and floors that differ. What fits by a floor's pattern alone is found out here.
// Single-threaded.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/alignment/rig/pose_selection.h"
#include "roomcast/alignment/rig/rig_refinement.h"

namespace roomcast::alignment {

/// One way to place the sensors, refined.
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

/// Checks answers for the same sensors, one after the other.
class RigCheck {
 public:
  /// Of the sensors whose refined places contradict what all others see, the one that does so most;
  /// of two that do so alike, the one that was less sure.
  [[nodiscard]] std::optional<std::size_t> contradicted_sensor(std::span<const RigPair> pairs,
                                                               const RigAnswer& answer);

 private:
  std::vector<bool> exact_colors_;  // of sensors whose colours agreed with another's before
};

}  // namespace roomcast::alignment
