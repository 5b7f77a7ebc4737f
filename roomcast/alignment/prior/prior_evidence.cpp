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
      a, b, weighed_matches(a, own_look_alikes(a), b, own_look_alikes(b), compare_views(a, b)));
}

Contradiction contradiction(const PoseEvidence& evidence) {
  if (is_too_much(evidence.space) || evidence.space.consistent_least < kMinOverlap) {
    return Contradiction::kShapes;
  }
  if (evidence.photo.textured > kTextured && evidence.photo.correlation < kMinCorrelation)
    return Contradiction::kColors;
  return Contradiction::kNone;
}

bool is_too_much(const FreeSpaceCheck& space) {
  return space.conflict() > kMaxConflict;
}

}  // namespace roomcast::alignment
