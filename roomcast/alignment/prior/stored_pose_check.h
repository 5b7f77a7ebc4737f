// SPDX-License-Identifier: Apache-2.0
// Whether two sensors still stand to each other as they once did: a hub that was started again
// knows where they stood, but not whether somebody moved one of them meanwhile. What both see now
// is compared there. It confirms the pose only where a guess there would be taken, and come out
// there (nudged_pose.h): along a bare wall nothing tells one place from the next. Metres,
// millimetres where a name says so. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/pair/pair_candidates.h"
#include "roomcast/alignment/prior/prior_evidence.h"

namespace roomcast::alignment {

enum class StoredPoseVerdict { kUntold, kConfirmed, kContradicted };

struct StoredPoseCheck {
  StoredPoseVerdict verdict = StoredPoseVerdict::kUntold;
  Contradiction contradiction = Contradiction::kNone;  // of a pose that is contradicted
  double expected_error_mm = 0;  // of one that is confirmed: standard deviation 2.5 m ahead of b
};

[[nodiscard]] StoredPoseCheck stored_pose_check(const PairCandidates& pair,
                                                const RigidTransform& world_from_a,
                                                const RigidTransform& world_from_b);

}  // namespace roomcast::alignment
