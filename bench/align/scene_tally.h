// SPDX-License-Identifier: Apache-2.0
// Counts answers scene by scene, to show which kinds of room are refused or answered wrongly.
// Single-threaded.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/align/align_tally.h"

namespace roomcast::bench {

/// The pairs of one scene in one class of overlap.
struct SceneRow {
  std::string scene, overlap;
  int pairs = 0, right = 0, refused = 0, wrong = 0;  // refused may be correct, see `overlap`
};

class SceneTally {
 public:
  /// Scenes keep the order of their first use.
  [[nodiscard]] AlignTally& of(const std::string& scene);
  [[nodiscard]] std::vector<SceneRow> rows() const;

 private:
  std::vector<std::pair<std::string, AlignTally>> scenes_;
};

}  // namespace roomcast::bench
