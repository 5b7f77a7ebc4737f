// SPDX-License-Identifier: Apache-2.0
// RoomWorld: keeps the world frame of a room fixed. When new data arrives, a sensor with a known
// pose keeps it, bit for bit, and the others are placed relative to it, so that the room does not
// jump; a pose changes only if the new estimate differs by more than the expected error. If no pose
// is known, alignment chooses a provisional world. A provisional world ends when a sensor supplies
// its pose: sensors without a connection to that one then lose their poses, because the transform
// between the two worlds is unknown. Deterministic. Single-threaded.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/service/placement.h"

namespace roomcast::alignment {

/// Whether a single stored pose may anchor the world if no better pose is present.
enum class LoneStoredPose { kDoubted, kTrusted };

class RoomWorld {
 public:
  /// The poses of the report, transformed as a whole so that one of its sensors with a known pose
  /// keeps it: the one for which most other sensors keep theirs, too, so that the room stays in
  /// place when a sensor was moved unnoticed. Given poses have precedence over estimated ones, and
  /// estimated ones over stored ones; of the latter two have to agree unless nothing better is
  /// present (`lone`). A report with a single sensor is no evidence of its pose: a stored pose is
  /// not confirmed by it.
  [[nodiscard]] std::vector<Placement> place(const alignment::AlignmentReport& report,
                                             const KnownRoom& known,
                                             LoneStoredPose lone = LoneStoredPose::kTrusted);

  /// The estimated poses that are in the world of the given poses, if there are any of those; else
  /// all.
  [[nodiscard]] KnownPoses estimated_in_world(const KnownRoom& known) const;

 private:
  /// The only connected sensor with a pose, if its world is provisional and the report places
  /// others without it: it is then given up.
  [[nodiscard]] std::optional<std::string> lone_world(const alignment::AlignmentReport& report,
                                                      const KnownRoom& known) const;

  std::set<std::string> provisional_;  // the sensors that were placed in a provisional world
};

}  // namespace roomcast::alignment
