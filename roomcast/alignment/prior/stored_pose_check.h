// SPDX-License-Identifier: Apache-2.0
// Checks whether the stored relative pose of two sensors is still valid. A restarted hub knows
// stored poses, but not whether a sensor was moved meanwhile. The current views of both are
// compared at the stored pose. It is confirmed only if it would be accepted as a prior and its
// refinement ends at the same pose (nudged_pose.h): along a bare wall all poses fit alike and none
// is confirmed. Metres, millimetres where a name says so. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/prior/nudged_pose.h"

namespace roomcast::alignment {

enum class StoredPoseVerdict { kInconclusive, kConfirmed, kContradicted };

struct StoredPoseCheck {
  StoredPoseVerdict verdict = StoredPoseVerdict::kInconclusive;
  Contradiction contradiction = Contradiction::kNone;  // if kContradicted
  double expected_error_mm = 0;  // if kConfirmed: standard deviation 2.5 m ahead of b
};

/// Chosen on simulated rooms (docs/benchmarks/live-alignment.md).
struct StoredPoseOptions {
  double min_seen = 0.05;  // share of a view: less surface in common is inconclusive
  /// From the stored pose to the refined one, at most. Beyond what a pose may be off, and below
  /// what a moved sensor is.
  double max_shift_m = 0.03, max_turn_rad = 0.012;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_seen", min_seen, Range{0, 1});
    visit("max_shift_m", max_shift_m, Range{0, 10});
    visit("max_turn_rad", max_turn_rad, Range{0, 3.2});
  }
  [[nodiscard]] Status check() const { return check_fields("StoredPoseOptions", *this); }
};

/// `nudge`: how the stored pose is judged as a prior.
[[nodiscard]] StoredPoseCheck stored_pose_check(const PairCandidates& pair,
                                                const RigidTransform& world_from_a,
                                                const RigidTransform& world_from_b,
                                                const StoredPoseOptions& options = {},
                                                const NudgeOptions& nudge = {});

}  // namespace roomcast::alignment
