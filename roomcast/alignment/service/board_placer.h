// SPDX-License-Identifier: Apache-2.0
// BoardPlacer: places sensors that share nothing with the others by a printed tag that was held
// where both see it, here and there. Pure. Single-threaded.
#pragma once

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/board/board_match.h"
#include "roomcast/alignment/service/placement.h"
#include "roomcast/core/clock.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

/// Somebody may take so long to hold it everywhere.
inline constexpr std::chrono::seconds kBoardRemembered{120};

class BoardPlacer {
 public:
  /// The sensor stands elsewhere now.
  void forget(const std::string& sensor) { seen_.erase(sensor); }
  void see(const std::string& sensor, const wire::pb::Sightings& sightings);

  /// Those of the `lost` that can be placed beside one of the `placed`, or beside one that was so
  /// placed before; for the others that have seen a board the reason why not. Where nobody is
  /// placed, the first of the seeds beside whom another can be makes the world.
  [[nodiscard]] std::vector<Placement> place(const KnownPoses& placed,
                                             const std::set<std::string>& lost,
                                             const Seeds& seeds) const;

 private:
  [[nodiscard]] std::vector<Placement> place_beside(KnownPoses placed,
                                                    const std::set<std::string>& lost) const;
  using Sightings = std::deque<alignment::TagSighting>;  // in the order of time
  [[nodiscard]] Placement place_one(const std::string& sensor, const Sightings& seen,
                                    const KnownPoses& placed) const;

  std::map<std::string, Sightings> seen_;
};

}  // namespace roomcast::alignment
