// SPDX-License-Identifier: Apache-2.0
// Detects repeating features. Floor prints, tiles, posters and chairs look the same in several
// places, so a match between two of them carries no information. A feature is rated by its most
// similar look-alike elsewhere in its own view. A feature that repeats within any one view is a
// repeat for every view of the rig, even for a sensor that sees it only once (the repeat
// vocabulary). Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

/// Descriptor distances are 0..2. Chosen on the development rooms (alignment_options.h), unless
/// noted.
struct RepeatOptions {
  float apart_m = 0.12F;          // a similar feature nearer than this is on the same thing
  float repeat_distance = 0.62F;  // to a look-alike: repeats are nearer. 84 pairs of views of
                                  // house3: 0 of 15 answers wrong, with 0.45 2 of 19
  float min_weight = 0.05F;       // of a match of repeats
  /// A match has no weight at this ratio of its distance to its features' look-alike distance, and
  /// full weight at the range below.
  float worthless_ratio = 1.15F, ratio_range = 0.4F;
  /// A good match of two repeats does not show which of the repeats it is: features with this
  /// look-alike distance have no weight, those the range above have full weight.
  float surely_repeats = 0.3F, repeat_range = 0.25F;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("apart_m", apart_m, Range{0, 10});
    visit("repeat_distance", repeat_distance, Range{0, 2});
    visit("min_weight", min_weight, Range{0, 1});
    visit("worthless_ratio", worthless_ratio, Range{0, 10});
    visit("ratio_range", ratio_range, Range{0.01, 10});
    visit("surely_repeats", surely_repeats, Range{0, 2});
    visit("repeat_range", repeat_range, Range{0.01, 2});
  }
  [[nodiscard]] Status check() const { return check_fields("RepeatOptions", *this); }
};

/// Sets `nearest_similar_distance` of every feature: the descriptor distance to its most similar
/// feature elsewhere in space.
void compute_ambiguity(FeatureSet& set, const RepeatOptions& options = {});

/// Whether the feature has a close look-alike elsewhere in its own view. Requires
/// `compute_ambiguity`.
[[nodiscard]] bool repeats(const Feature& feature, const RepeatOptions& options = {});

/// Weight of a match, 0.05 (repeats) to 1 (unique), from its descriptor distance and both features'
/// look-alike distances.
[[nodiscard]] float uniqueness(float distance, float look_alike_a, float look_alike_b,
                               const RepeatOptions& options = {});

}  // namespace roomcast::alignment
