// SPDX-License-Identifier: Apache-2.0
// How the features of two sensors look alike: mutual nearest neighbours, one to many, and what
// repeats. Where structure repeats the right partner is often not the nearest one, so each feature
// keeps its few nearest; a match is made where both keep each other. Ties go to the lower index:
// same input, same matches. All descriptors of one set are compared with all of the other, once.
// Thread-safe (no state).
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/alignment/feature/feature_set.h"

namespace roomcast::alignment {

struct DescriptorMatch {
  std::uint32_t a = 0, b = 0;  // indices
  float distance = 0;          // 0..2
};

struct FeatureComparison {
  std::vector<DescriptorMatch> matches;  // in the order of a, then b
  /// Of each feature: its descriptor's distance to the nearest of the other set that repeats there
  /// (repeats.h); 2 where there is none.
  std::vector<float> a_to_repeat, b_to_repeat;
};

inline constexpr int kPartners = 3;

/// No match is further apart than `largest_distance`.
[[nodiscard]] FeatureComparison compare_features(const FeatureSet& a, const FeatureSet& b,
                                                 float largest_distance);

}  // namespace roomcast::alignment
