// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/stored_pose_check.h"

namespace roomcast::alignment {

StoredPoseCheck stored_pose_check(const PairCandidates& pair, const RigidTransform& world_from_a,
                                  const RigidTransform& world_from_b,
                                  const StoredPoseOptions& options, const NudgeOptions& nudge) {
  const PoseEvidence evidence = pair.examine(world_from_a.inverse() * world_from_b);
  const Contradiction against = contradiction(evidence, nudge.evidence);
  if (against == Contradiction::kMovement) return {StoredPoseVerdict::kContradicted, against, 0};
  if (evidence.space.consistent + evidence.space.violating < options.min_seen) return {};
  if (against == Contradiction::kColors || has_free_space_conflict(evidence.space, nudge.evidence))
    return {StoredPoseVerdict::kContradicted, against, 0};
  if (against != Contradiction::kNone) return {};  // too little evidence
  const auto found = refined_prior(pair, world_from_a, world_from_b, nudge);
  if (!found) return {};
  const PoseDifference off = difference(found->world_from_depth, world_from_b);
  if (off.distance_m > options.max_shift_m || off.angle_rad > options.max_turn_rad) return {};
  return {StoredPoseVerdict::kConfirmed, Contradiction::kNone, found->expected_error_mm};
}

}  // namespace roomcast::alignment
