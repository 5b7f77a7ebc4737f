// SPDX-License-Identifier: Apache-2.0
// Messages for users: why a pair or a sensor could not be aligned, and what would help. Thread-safe
// (no state).
#pragma once

#include <string>

#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// Why the pair alone does not determine its relative pose; empty if it does.
[[nodiscard]] std::string why_pair_is_refused(const PairCandidates& pair);

/// The same for a pair whose sensors are placed through other pairs.
[[nodiscard]] std::string why_pair_says_little(const PairCandidates& pair,
                                               const PoseEvidence& at_placed_pose);

}  // namespace roomcast::alignment
