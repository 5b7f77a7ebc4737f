// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from matches most of which may be wrong: second-order spatial compatibility (SC2,
// Chen et al., CVPR 2022). Two matches are compatible when their points are equally far apart in
// both views. A match gets votes from the compatible matches that are compatible with each other.
// No random choice: the same matches give the same hypotheses. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

struct VoteOptions {
  std::size_t max_matches = 1200;  // the heaviest are used
  std::size_t max_seeds = 150;
  std::size_t max_hypotheses = 16;
  float inlier_m = 0.06F;
  float tolerance_m = 0.02F;  // between distances in both views, plus 1.2 % of them
};

struct PoseHypothesis {
  RigidTransform a_from_b;
  double support = 0;  // match_support().weight of the agreeing matches
};

/// Most support first, without duplicates.
[[nodiscard]] std::vector<PoseHypothesis> vote_for_poses(std::span<const PointMatch> matches,
                                                         const VoteOptions& options = {});

}  // namespace roomcast::alignment
