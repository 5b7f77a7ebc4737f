// SPDX-License-Identifier: Apache-2.0
// The sensors of a rig under test: those of the room, and strangers from other rooms, which have no
// answer. Shared by the suites that simulate rigs.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {

template <class View>
struct RigEntry {
  const View* seen;
  bool native;  // belongs to the room
};

/// The sensors that have a view.
template <class View>
std::vector<RigEntry<View>> entries_of(const std::vector<View>& room,
                                       const std::vector<View>& strangers) {
  std::vector<RigEntry<View>> entries;
  for (const View& seen : room) {
    if (seen.view) entries.push_back({&seen, true});
  }
  for (const View& seen : strangers) {
    if (seen.view) entries.push_back({&seen, false});
  }
  return entries;
}

/// Aligns under names that reveal nothing about the rooms.
template <class View>
alignment::AlignmentReport aligned_unnamed(const std::vector<RigEntry<View>>& entries) {
  alignment::RigAligner aligner({}, alignment::DepthScaling::kEstimated);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto view = std::make_shared<alignment::SensorView>(*entries[i].seen->view);
    view->name = "v" + std::to_string(i);
    aligner.add(std::move(view));
  }
  return aligner.solve();
}

}  // namespace roomcast::bench
