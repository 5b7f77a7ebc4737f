// SPDX-License-Identifier: Apache-2.0
// Checks whether the stored relative pose of two sensors is still valid. A restarted hub knows
// stored poses, but not whether a sensor was moved meanwhile. The current views of both are
// compared at the stored pose. It is confirmed only if it would be accepted as a prior and its
// refinement ends at the same pose (nudged_pose.h): along a bare wall all poses fit alike and none
// is confirmed. Metres, millimetres where a name says so. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/pair/pair_candidates.h"
#include "roomcast/alignment/prior/prior_evidence.h"

namespace roomcast::alignment {

enum class StoredPoseVerdict { kInconclusive, kConfirmed, kContradicted };

struct StoredPoseCheck {
  StoredPoseVerdict verdict = StoredPoseVerdict::kInconclusive;
  Contradiction contradiction = Contradiction::kNone;  // if kContradicted
  double expected_error_mm = 0;  // if kConfirmed: standard deviation 2.5 m ahead of b
};

[[nodiscard]] StoredPoseCheck stored_pose_check(const PairCandidates& pair,
                                                const RigidTransform& world_from_a,
                                                const RigidTransform& world_from_b);

}  // namespace roomcast::alignment
