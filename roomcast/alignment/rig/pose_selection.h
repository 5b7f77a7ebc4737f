// SPDX-License-Identifier: Apache-2.0
// Selects the pairs' hypotheses that fit together. An answer places sensors along a tree of
// hypotheses and is scored by the evidence of all pairs, also of those that only close a loop. Each
// edge of the tree must be strong, by itself or by the pooled evidence of all pairs that it
// connects. Beam search lets eight sensors with a dozen hypotheses per pair take seconds. A sensor
// is accepted only if no answer that places it elsewhere, or not at all, scores nearly as well.
// Metres. Single-threaded, deterministic.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// The candidates of two sensors, given by their indices in the rig; first < second.
struct RigPair {
  std::size_t first = 0, second = 0;  // sensors a and b of the candidates
  const PairCandidates* candidates = nullptr;
};

/// One way to place the sensors.
struct PlacedGroups {
  std::vector<std::size_t> group;                 // per sensor: the lowest sensor placed with it
  std::vector<RigidTransform> group_from_sensor;  // in the frame of that lowest sensor
  double score = 0;

  [[nodiscard]] bool together(std::size_t one, std::size_t other) const {
    return group[one] == group[other];
  }
  [[nodiscard]] RigidTransform relative(std::size_t to, std::size_t from) const {
    return group_from_sensor[to].inverse() * group_from_sensor[from];
  }
};

struct PoseSelection {
  PlacedGroups best;
  std::vector<double>
      margin_to_rival;  // per sensor: score difference to the best answer that places it elsewhere
  std::vector<double>
      margin_to_unplaced;  // per sensor: score difference to the best answer that leaves it out
  std::size_t origin = 0;  // the lowest sensor of the largest group
};

[[nodiscard]] PoseSelection select_poses(std::size_t sensors, std::span<const RigPair> pairs);

}  // namespace roomcast::alignment
