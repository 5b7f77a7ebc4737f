// SPDX-License-Identifier: Apache-2.0
// Support of matches for a pose. Many features on one small object are a single observation, so
// support counts the places in space that agree: the sum over 10 cm cells of the best match's
// weight. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

struct MatchSupport {
  double weight = 0;  // sum over cells of the best match's weight
  int cells = 0;      // 5 cm cells with any agreeing match
};

[[nodiscard]] std::vector<PointMatch> agreeing_matches(std::span<const PointMatch> matches,
                                                       const RigidTransform& a_from_b,
                                                       float tolerance_m);

[[nodiscard]] MatchSupport match_support(std::span<const PointMatch> agreeing);

}  // namespace roomcast::alignment
