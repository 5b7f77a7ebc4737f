// SPDX-License-Identifier: Apache-2.0
// Chooses the sensor that defines the world if none is placed: the first seed from which another
// sensor can be placed. One sensor alone stays unplaced. No I/O.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/service/placement.h"

namespace roomcast::alignment {

/// `place_relative_to(placed, lost)` returns placements of the lost sensors. If `placed` and
/// `seeds` are empty, no sensor is placed.
template <class PlaceBeside>
std::vector<Placement> place_or_seed(const KnownPoses& placed, const std::set<std::string>& lost,
                                     const Seeds& seeds, const PlaceBeside& place_relative_to) {
  if (!placed.empty()) return place_relative_to(placed, lost);
  std::vector<Placement> reasons;
  for (const auto& [seed, world_from_depth] : seeds) {
    std::set<std::string> others = lost;
    others.erase(seed);
    auto placements = place_relative_to(KnownPoses{{seed, world_from_depth}}, others);
    const bool any = std::ranges::any_of(
        placements, [](const Placement& placement) { return placement.pose.is_placed(); });
    if (any) {
      placements.push_back(placed_at(seed, world_from_depth, 0));
      return placements;
    }
    if (reasons.empty()) reasons = std::move(placements);
  }
  return reasons;
}

}  // namespace roomcast::alignment
