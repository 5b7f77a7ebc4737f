// SPDX-License-Identifier: Apache-2.0
// Selects the pairs' hypotheses that fit together. An answer places sensors along a tree of
// hypotheses and is scored by the evidence of all pairs, also of those that only close a loop. Each
// edge of the tree must be strong, by itself or by the pooled evidence of all pairs that it
// connects. Beam search lets eight sensors with a dozen hypotheses per pair take seconds. A sensor
// is accepted only if no answer that places it elsewhere, or not at all, scores nearly as well.
// Metres. Single-threaded, deterministic.
#pragma once

#include <cstddef>
#include <numbers>
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

/// Chosen on the development rooms (alignment_options.h).
struct PoseSelectionOptions {
  std::size_t edges_per_pair = 6;  // hypotheses of a pair that may be edges
  std::size_t beam = 24;           // answers kept of each size
  /// Poses that differ by less have the same evidence.
  double same_angle_rad = 0.7 * std::numbers::pi / 180, same_distance_m = 0.03;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("edges_per_pair", edges_per_pair, Range{1, 1000});
    visit("beam", beam, Range{1, 10000});
    visit("same_angle_rad", same_angle_rad, Range{0, std::numbers::pi});
    visit("same_distance_m", same_distance_m, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("PoseSelectionOptions", *this); }
};

/// `rivals` and `evidence`: as for the candidates of all pairs.
[[nodiscard]] PoseSelection select_poses(std::size_t sensors, std::span<const RigPair> pairs,
                                         const PoseSelectionOptions& options = {},
                                         const RivalOptions& rivals = {},
                                         const EvidenceOptions& evidence = {});

}  // namespace roomcast::alignment
