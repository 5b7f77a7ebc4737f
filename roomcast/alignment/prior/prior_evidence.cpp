// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/prior_evidence.h"

namespace roomcast::alignment {
namespace {

constexpr double kMinOverlap = 0.05, kMaxConflict = 0.08;
constexpr double kMinCorrelation = 0.35, kTextured = 0.004;
constexpr double kPerhapsOverlap = 0.02;  // at the prior: enough to compare the two

}  // namespace

std::optional<PlacedView> best_partner(const SensorView& view, const RigidTransform& guess,
                                       std::span<const PlacedView> others) {
  std::optional<PlacedView> best;
  double most = kPerhapsOverlap;
  for (const PlacedView& other : others) {
    const RigidTransform other_from_view = other.world_from_depth.inverse() * guess;
    const auto space =
        check_free_space(other.view->surface, view.surface, other_from_view, kTestedPoints);
    const double seen = space.consistent + space.violating;  // a prior is off by decimetres
    if (seen <= most) continue;
    most = seen;
    best = other;
  }
  return best;
}

PairCandidates candidates_of(const SensorView& a, const SensorView& b) {
  return PairCandidates(
      a, b, weighted_matches(a, own_ambiguity(a), b, own_ambiguity(b), compare_views(a, b)));
}

Contradiction contradiction(const PoseEvidence& evidence) {
  if (has_free_space_conflict(evidence.space) || evidence.space.min_consistent < kMinOverlap) {
    return Contradiction::kShapes;
  }
  if (evidence.photo.textured > kTextured && evidence.photo.correlation < kMinCorrelation)
    return Contradiction::kColors;
  return Contradiction::kNone;
}

bool has_free_space_conflict(const FreeSpaceCheck& space) {
  return space.conflict() > kMaxConflict;
}

}  // namespace roomcast::alignment
