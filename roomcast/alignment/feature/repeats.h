// SPDX-License-Identifier: Apache-2.0
// Detects repeating features. Floor prints, tiles, posters and chairs look the same in several
// places, so a match between two of them carries no information. A feature is rated by its most
// similar look-alike elsewhere in its own view. A feature that repeats within any one view is a
// repeat for every view of the rig, even for a sensor that sees it only once (the repeat
// vocabulary). Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"

namespace roomcast::alignment {

/// Sets `nearest_similar_distance` of every feature: the descriptor distance to its most similar
/// feature more than 12 cm away in space.
void compute_ambiguity(FeatureSet& set);

/// Whether the feature has a close look-alike elsewhere in its own view. Requires
/// `compute_ambiguity`.
[[nodiscard]] bool repeats(const Feature& feature);

/// Weight of a match, 0.05 (repeats) to 1 (unique), from its descriptor distance and both features'
/// look-alike distances.
[[nodiscard]] float uniqueness(float distance, float look_alike_a, float look_alike_b);

}  // namespace roomcast::alignment
