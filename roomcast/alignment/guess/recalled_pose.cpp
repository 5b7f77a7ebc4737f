// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/guess/recalled_pose.h"

#include "roomcast/alignment/guess/nudged_pose.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::align {
namespace {

constexpr double kLeastSeen = 0.05;  // of a view: so much has to be judged to contradict a pose
constexpr double kMostOff_m = 0.03, kMostOff_rad = 0.012;  // of where what both see puts it

}  // namespace

RecalledPose recalled_pose(const PairCandidates& pair, const RigidTransform& world_from_a,
                           const RigidTransform& world_from_b) {
  const PoseEvidence evidence = pair.examine(world_from_a.inverse() * world_from_b);
  if (evidence.space.consistent + evidence.space.violating < kLeastSeen) return {};
  const Contradiction against = contradiction(evidence);
  if (against == Contradiction::kColors || is_too_much(evidence.space))
    return {Recollection::kContradicted, against, 0};
  if (against != Contradiction::kNone) return {};  // too little to go by
  const auto found = refined_guess(pair, world_from_a, world_from_b);
  if (!found) return {};
  const PoseDifference off = difference(found->world_from_depth, world_from_b);
  if (off.distance_m > kMostOff_m || off.angle_rad > kMostOff_rad) return {};
  return {Recollection::kConfirmed, Contradiction::kNone, found->expected_error_mm};
}

}  // namespace roomcast::align
