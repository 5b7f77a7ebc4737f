// SPDX-License-Identifier: Apache-2.0
#include "bench/align/scene_tally.h"

#include <algorithm>

namespace roomcast::bench {

AlignTally& SceneTally::of(const std::string& scene) {
  const auto found =
      std::ranges::find_if(scenes_, [&](const auto& known) { return known.first == scene; });
  if (found != scenes_.end()) return found->second;
  scenes_.emplace_back(scene, AlignTally());
  return scenes_.back().second;
}

std::vector<SceneRow> SceneTally::rows() const {
  std::vector<SceneRow> rows;
  for (const auto& [scene, tally] : scenes_) {
    for (const AlignRow& row : tally.rows(scene, "", 0)) {
      rows.push_back(
          {scene, row.overlap, row.pairs, row.right, row.pairs - row.accepted, row.accepted_wrong});
    }
  }
  return rows;
}

}  // namespace roomcast::bench
