// SPDX-License-Identifier: Apache-2.0
// Messages for users: why a pair or a sensor could not be aligned, and what would help. Thread-safe
// (no state).
#pragma once

#include <string>

#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// Which reason is given. By hand.
struct RefusalOptions {
  double little_overlap = 0.08;   // share of a view; below which overlap is the reason
  std::size_t few_features = 50;  // of a view; below which its texture is the reason

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("little_overlap", little_overlap, Range{0, 1});
    visit("few_features", few_features, Range{0, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("RefusalOptions", *this); }
};

/// Why the pair alone does not determine its relative pose; empty if it does.
[[nodiscard]] std::string why_pair_is_refused(const PairCandidates& pair,
                                              const RefusalOptions& options = {});

/// The same for a pair whose sensors are placed through other pairs.
[[nodiscard]] std::string why_pair_says_little(const PairCandidates& pair,
                                               const PoseEvidence& at_placed_pose,
                                               const RefusalOptions& options = {});

}  // namespace roomcast::alignment
