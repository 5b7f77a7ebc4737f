// SPDX-License-Identifier: Apache-2.0
// Which features repeat. Floor prints, tiles, posters and chairs look the same in several places,
// and a match between two of them says nothing. A feature is judged by its most similar look-alike
// elsewhere in its own view; what repeats within any one view is a repeat for every view of the
// rig, even for a sensor that sees it only once (the repeat vocabulary). Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"

namespace roomcast::alignment {

/// Sets `look_alike` of every feature: its descriptor's distance to the nearest one that lies at
/// least 12 cm away in space.
void find_look_alikes(FeatureSet& set);

/// Whether there is a look-alike near enough elsewhere in the feature's own view
/// (`find_look_alikes` has been called).
[[nodiscard]] bool repeats(const Feature& feature);

/// 0.05 (repeats) to 1 (unique): what a match of two features with this distance is worth.
[[nodiscard]] float uniqueness(float distance, float look_alike_a, float look_alike_b);

}  // namespace roomcast::alignment
