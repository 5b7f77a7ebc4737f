// SPDX-License-Identifier: Apache-2.0
// Which features of two sensors look alike: mutual nearest neighbours, one to many. Where structure
// repeats the right partner is often not the nearest one, so each feature keeps its few nearest; a
// match is made where both keep each other. Ties go to the lower index: same input, same matches.
// Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/align/feature/feature_set.h"

namespace roomcast::align {

struct DescriptorMatch {
  std::uint32_t a = 0, b = 0;  // indices
  float distance = 0;          // 0..2
};

inline constexpr int kPartners = 3;

/// In the order of a, then b; none further apart than `largest_distance`.
[[nodiscard]] std::vector<DescriptorMatch> match_descriptors(std::span<const Descriptor> a,
                                                             std::span<const Descriptor> b,
                                                             float largest_distance);

}  // namespace roomcast::align
