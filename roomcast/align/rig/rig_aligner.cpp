// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/rig/rig_aligner.h"

#include <algorithm>

#include <fmt/format.h>

#include "roomcast/align/rig/placed_rig.h"

namespace roomcast::align {

void RigAligner::add(std::shared_ptr<const SensorView> view) {
  remove(view->name);
  views_.push_back(std::move(view));
}

void RigAligner::remove(const std::string& name) {
  std::erase_if(candidates_, [&](const auto& entry) {
    return entry.first.first == name || entry.first.second == name;
  });
  std::erase_if(views_, [&](const auto& view) { return view->name == name; });
}

AlignmentReport RigAligner::solve(const AlignProgress& progress) {
  compare_new_pairs(progress);
  if (progress) progress("placing all sensors", 0.9);
  std::vector<const SensorView*> views;
  for (const auto& view : views_) views.push_back(view.get());
  return place_rig(views, pairs());
}

void RigAligner::compare_new_pairs(const AlignProgress& progress) {
  std::vector<const SensorView*> views;
  for (const auto& view : views_) views.push_back(view.get());
  const std::vector<LookAlikes> look_alikes = look_alikes_of_rig(views);
  const double all = static_cast<double>(views.size() * (views.size() - 1)) / 2;
  double done = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = i + 1; j < views.size(); ++j) {
      auto& candidates = candidates_[{views[i]->name, views[j]->name}];
      if (progress) {
        progress(fmt::format("comparing {} with {}", views[i]->name, views[j]->name), done++ / all);
      }
      if (candidates) continue;
      candidates = std::make_unique<PairCandidates>(
          *views[i], *views[j],
          match_features(*views[i], look_alikes[i], *views[j], look_alikes[j]));
    }
  }
}

std::vector<RigPair> RigAligner::pairs() const {
  std::vector<RigPair> pairs;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    for (std::size_t j = i + 1; j < views_.size(); ++j) {
      const auto found = candidates_.find({views_[i]->name, views_[j]->name});
      pairs.push_back({i, j, found->second.get()});
    }
  }
  return pairs;
}

}  // namespace roomcast::align
