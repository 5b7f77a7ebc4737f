// SPDX-License-Identifier: Apache-2.0
// Answers counted scene by scene: which kinds of room are refused, or answered wrongly.
// Single-threaded.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/align/align_tally.h"

namespace roomcast::bench {

/// Pairs of one scene that share about as much.
struct SceneRow {
  std::string scene, overlap;
  int pairs = 0, right = 0, refused = 0, wrong = 0;  // refused may be right, see `overlap`
};

class SceneTally {
 public:
  /// Scenes are kept in the order in which they came.
  [[nodiscard]] AlignTally& of(const std::string& scene);
  [[nodiscard]] std::vector<SceneRow> rows() const;

 private:
  std::vector<std::pair<std::string, AlignTally>> scenes_;
};

}  // namespace roomcast::bench
