// SPDX-License-Identifier: Apache-2.0
// Sentences for people: why a pair or a sensor could not be aligned, and what would help.
// Thread-safe (no state).
#pragma once

#include <string>

#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// Why the pair alone does not settle how its sensors stand to each other. Empty when it does.
[[nodiscard]] std::string why_pair_is_refused(const PairCandidates& pair);

/// The same for a pair whose sensors stand as others say.
[[nodiscard]] std::string why_pair_says_little(const PairCandidates& pair,
                                               const PoseEvidence& at_its_place);

}  // namespace roomcast::alignment
