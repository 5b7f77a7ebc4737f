// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from what moves, for pairs whose pictures gave no conclusive one: sensors that
// face each other across a room match no features, but both see the floor and the same person. Two
// floors leave three unknowns: a turn about the vertical, and a shift. What moves gives the shift
// for each turn, and common surfaces choose among the turns. Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/alignment/pair/moving_consistency.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/spatial_vote.h"

namespace roomcast::alignment {

/// By hand.
struct MovingHypothesisOptions {
  int turns = 120;             // tried, evenly spread over a full one
  std::size_t kept = 8;        // of them are refined
  double inside_m = 0.12;      // from the visible surface of a person to the middle
  double max_scatter_m = 0.3;  // of the shifts that single instants give
  std::size_t min_instants = 1;
  double max_conflict = 0.3;  // of surfaces, before refinement
  /// Refinement by surfaces alone, from up to so far away.
  PoseRefinementOptions coarse{.max_steps = 16, .points = 800, .reach_m = 0.35F};

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("turns", turns, Range{1, 10000});
    visit("kept", kept, Range{1, 1000});
    visit("inside_m", inside_m, Range{0, 1});
    visit("max_scatter_m", max_scatter_m, Range{0, 10});
    visit("min_instants", min_instants, Range{1, 1000});
    visit("max_conflict", max_conflict, Range{0, 1});
    visit("coarse", coarse);
  }
  [[nodiscard]] Status check() const { return check_fields("MovingHypothesisOptions", *this); }
};

/// Best first; none if a view has no floor or nothing moves in both at the same time.
[[nodiscard]] std::vector<PoseHypothesis> hypotheses_by_motion(
    const SensorView& a, const SensorView& b, const MovingHypothesisOptions& options = {},
    const MovingConsistencyOptions& moving = {}, const FreeSpaceOptions& space = {});

}  // namespace roomcast::alignment
