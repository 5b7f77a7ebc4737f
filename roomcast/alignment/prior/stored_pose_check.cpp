// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/stored_pose_check.h"

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/prior/nudged_pose.h"

namespace roomcast::alignment {
namespace {

constexpr double kMinSeen = 0.05;                        // of a view: less overlap is inconclusive
constexpr double kMaxOff_m = 0.03, kMaxOff_rad = 0.012;  // from the stored pose to the refined one

}  // namespace

StoredPoseCheck stored_pose_check(const PairCandidates& pair, const RigidTransform& world_from_a,
                                  const RigidTransform& world_from_b) {
  const PoseEvidence evidence = pair.examine(world_from_a.inverse() * world_from_b);
  if (evidence.space.consistent + evidence.space.violating < kMinSeen) return {};
  const Contradiction against = contradiction(evidence);
  if (against == Contradiction::kColors || has_free_space_conflict(evidence.space))
    return {StoredPoseVerdict::kContradicted, against, 0};
  if (against != Contradiction::kNone) return {};  // too little evidence
  const auto found = refined_prior(pair, world_from_a, world_from_b);
  if (!found) return {};
  const PoseDifference off = difference(found->world_from_depth, world_from_b);
  if (off.distance_m > kMaxOff_m || off.angle_rad > kMaxOff_rad) return {};
  return {StoredPoseVerdict::kConfirmed, Contradiction::kNone, found->expected_error_mm};
}

}  // namespace roomcast::alignment
