// SPDX-License-Identifier: Apache-2.0
// Compares the descriptors of two sensors' features: mutual nearest neighbours, several per
// feature, and distances to repeating features. In repetitive structure the right partner is often
// not the nearest, so each feature keeps its kPartners nearest. A match needs both features to keep
// each other. Ties go to the lower index, so the same input gives the same matches. All descriptors
// of one set are compared with all of the other, once. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/feature/repeats.h"

namespace roomcast::alignment {

struct DescriptorMatch {
  std::uint32_t a = 0, b = 0;  // indices
  float distance = 0;          // 0..2
};

struct FeatureComparison {
  std::vector<DescriptorMatch> matches;  // in the order of a, then b
  /// Per feature: the descriptor distance to the nearest feature of the other set that repeats
  /// there (repeats.h); 2 where there is none.
  std::vector<float> a_to_repeat, b_to_repeat;
};

inline constexpr int kPartners = 3;

/// Matches have descriptor distances below `largest_distance`.
[[nodiscard]] FeatureComparison compare_features(const FeatureSet& a, const FeatureSet& b,
                                                 float largest_distance,
                                                 const RepeatOptions& repeating = {});

}  // namespace roomcast::alignment
