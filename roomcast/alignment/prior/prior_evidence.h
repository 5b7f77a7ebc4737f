// SPDX-License-Identifier: Apache-2.0
// Evidence of placed sensors for or against a prior pose of another sensor: the placed sensor with
// the largest overlap at that pose, and whether the surfaces of both fit. Metres. Thread-safe (no
// state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// Chosen on simulated rooms (docs/benchmarks/live-alignment.md). Shares, unless noted.
struct PriorEvidenceOptions {
  double min_overlap = 0.05;      // less surface in common proves nothing
  double max_conflict = 0.08;     // more contradicts; edges a little misplaced make less
  double min_correlation = 0.35;  // of colours; less contradicts
  double textured = 0.004;        // of a view; with less, colours are no evidence
  double moving_disagrees = 0.8;  // of 1: agreement of what moves below minus this contradicts
  double perhaps_overlap = 0.02;  // at the prior: enough to compare the two

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_overlap", min_overlap, Range{0, 1});
    visit("max_conflict", max_conflict, Range{0, 1});
    visit("min_correlation", min_correlation, Range{-1, 1});
    visit("textured", textured, Range{0, 1});
    visit("moving_disagrees", moving_disagrees, Range{0, 1});
    visit("perhaps_overlap", perhaps_overlap, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("PriorEvidenceOptions", *this); }
};

/// Another sensor, whose pose is known.
struct PlacedView {
  const SensorView* view = nullptr;
  RigidTransform world_from_depth;
};

/// The placed sensor with the largest overlap if the prior is about right; nothing if none
/// overlaps.
[[nodiscard]] std::optional<PlacedView> best_partner(const SensorView& view,
                                                     const RigidTransform& prior_world_from_depth,
                                                     std::span<const PlacedView> others,
                                                     const PriorEvidenceOptions& options = {},
                                                     const FreeSpaceOptions& space = {});

/// The pose candidates of this pair alone.
[[nodiscard]] PairCandidates candidates_of(const SensorView& a, const SensorView& b,
                                           const PairOptions& options = {});

/// The evidence against a pose. A pose with a prior needs less support than one without, but
/// nothing may contradict it.
enum class Contradiction { kNone, kShapes, kColors, kMovement };
[[nodiscard]] Contradiction contradiction(const PoseEvidence& evidence,
                                          const PriorEvidenceOptions& options = {});

/// Whether one sensor sees through surfaces that the other sees, by more than slightly misaligned
/// edges explain.
[[nodiscard]] bool has_free_space_conflict(const FreeSpaceCheck& space,
                                           const PriorEvidenceOptions& options = {});

}  // namespace roomcast::alignment
