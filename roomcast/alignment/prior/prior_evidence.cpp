// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/prior_evidence.h"

namespace roomcast::alignment {

std::optional<PlacedView> best_partner(const SensorView& view, const RigidTransform& guess,
                                       std::span<const PlacedView> others,
                                       const PriorEvidenceOptions& options,
                                       const FreeSpaceOptions& free_space) {
  std::optional<PlacedView> best;
  double most = options.perhaps_overlap;
  for (const PlacedView& other : others) {
    const RigidTransform other_from_view = other.world_from_depth.inverse() * guess;
    const auto space = check_free_space(other.view->surface, view.surface, other_from_view,
                                        free_space.points, free_space);
    const double seen = space.consistent + space.violating;  // a prior is off by decimetres
    if (seen <= most) continue;
    most = seen;
    best = other;
  }
  return best;
}

PairCandidates candidates_of(const SensorView& a, const SensorView& b, const PairOptions& options) {
  const ViewComparison comparison = compare_views(a, b, options.matching);
  return PairCandidates(
      a, b,
      weighted_matches(a, own_ambiguity(a), b, own_ambiguity(b), comparison, options.matching),
      options);
}

Contradiction contradiction(const PoseEvidence& evidence, const PriorEvidenceOptions& options) {
  if (evidence.moving_agreement < -options.moving_disagrees) return Contradiction::kMovement;
  if (has_free_space_conflict(evidence.space, options) ||
      evidence.space.min_consistent < options.min_overlap) {
    return Contradiction::kShapes;
  }
  if (evidence.photo.textured > options.textured &&
      evidence.photo.correlation < options.min_correlation)
    return Contradiction::kColors;
  return Contradiction::kNone;
}

bool has_free_space_conflict(const FreeSpaceCheck& space, const PriorEvidenceOptions& options) {
  return space.conflict() > options.max_conflict;
}

}  // namespace roomcast::alignment
