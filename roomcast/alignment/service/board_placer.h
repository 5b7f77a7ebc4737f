// SPDX-License-Identifier: Apache-2.0
// BoardPlacer: places sensors without overlap from sightings of a printed tag that was held at
// several places in both views. No I/O. Single-threaded.
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

/// How long sightings are kept: the time to hold the board at all places.
inline constexpr std::chrono::seconds kBoardRemembered{120};

class BoardPlacer {
 public:
  /// Discards the sightings of a sensor that was moved.
  void forget(const std::string& sensor) { seen_.erase(sensor); }
  void see(const std::string& sensor, const wire::pb::Sightings& sightings);

  /// Poses of those `lost` sensors that share board sightings with a `placed` sensor, or with one
  /// that this call placed before; for other lost sensors that have seen a board, the reason for
  /// the failure. If `placed` is empty, the first seed from which another sensor can be placed
  /// defines the world.
  [[nodiscard]] std::vector<Placement> place(const KnownPoses& placed,
                                             const std::set<std::string>& lost,
                                             const Seeds& seeds) const;

 private:
  [[nodiscard]] std::vector<Placement> place_relative_to(KnownPoses placed,
                                                         const std::set<std::string>& lost) const;
  using Sightings = std::deque<alignment::TagSighting>;  // sorted by time
  [[nodiscard]] Placement place_one(const std::string& sensor, const Sightings& seen,
                                    const KnownPoses& placed) const;

  std::map<std::string, Sightings> seen_;
};

}  // namespace roomcast::alignment
