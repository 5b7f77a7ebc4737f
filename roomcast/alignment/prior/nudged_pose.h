// SPDX-License-Identifier: Apache-2.0
// Verifies a prior pose that a person proposes for a sensor. The pose is refined, from the prior
// and from poses around it, on the surfaces that the sensor shares with others
// (pair/pose_refinement.h). The refined poses are scored by free space, colours and features like
// any other hypothesis (PairCandidates::examine). Because of the prior, less support is required
// than in alignment without one; but no evidence may contradict the pose, and no other pose near
// the prior may fit equally well. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <string>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/prior/prior_evidence.h"
#include "roomcast/core/result.h"

namespace roomcast::alignment {

/// By hand, for the errors of a person's guess, unless noted.
struct NudgeOptions {
  double max_shift_m = 0.6, max_turn_rad = 0.35;  // from the prior to the result
  /// Starts around the prior: moved along the floor, turned about the vertical. Refinement
  /// converges from about as far (pair/pose_refinement.h).
  double aside_m = 0.15, aside_rad = 0.07;
  double min_lead = 4;  // in score, over a rival; below a pair's own margin, because of the prior
  /// Surface points of each view, and their reach, for the expected error.
  std::size_t points = 6000;
  float reach_m = 0.05F;
  PriorEvidenceOptions evidence;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_shift_m", max_shift_m, Range{0, 100});
    visit("max_turn_rad", max_turn_rad, Range{0, 3.2});
    visit("aside_m", aside_m, Range{0, 10});
    visit("aside_rad", aside_rad, Range{0, 3.2});
    visit("min_lead", min_lead, Range{0, 1e6});
    visit("points", points, Range{1, 1e6});
    visit("reach_m", reach_m, Range{0.001, 10});
    visit("evidence", evidence);
  }
  [[nodiscard]] Status check() const { return check_fields("NudgeOptions", *this); }
};

struct NudgedPose {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;
  std::string beside;  // the placed sensor that it was verified against
};

/// kUnavailable: the prior is rejected; the message gives the reason and what would help.
[[nodiscard]] Result<NudgedPose> refined_prior(const SensorView& view,
                                               const RigidTransform& prior_world_from_depth,
                                               std::span<const PlacedView> others,
                                               const NudgeOptions& options = {},
                                               const PairOptions& pair_options = {});

/// As above, for one pair of sensors, where the pose of `a` is known. The prior is varied along the
/// floor and about the vertical. The error comes from the surfaces that both see.
[[nodiscard]] Result<NudgedPose> refined_prior(const PairCandidates& pair,
                                               const RigidTransform& world_from_a,
                                               const RigidTransform& prior_world_from_b,
                                               const NudgeOptions& options = {});

}  // namespace roomcast::alignment
