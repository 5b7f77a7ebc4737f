// SPDX-License-Identifier: Apache-2.0
// RoomWorld: the world that a room's sensors are placed in. It stays where it is: when something
// new is known, a sensor whose pose is known already keeps it, and the others are placed beside it,
// so that the rest of the room does not jump. Where no pose is known, alignment makes a world up.
// Such a world ends when somebody says where a sensor stands: those that nothing connects with it
// have no place then, for nobody knows how the two worlds lie. Deterministic. Single-threaded.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "roomcast/align/rig/alignment_report.h"
#include "roomcast/aligner/placement.h"

namespace roomcast::aligner {

class RoomWorld {
 public:
  /// What the report says, moved as a whole so that one of its sensors that has a known pose keeps
  /// it: the one with whom most others keep theirs, too, so that the room stays where it is when a
  /// sensor was moved unnoticed. `given`: poses that hold whatever is found, and go before
  /// `found_before`, where the room shows the others now.
  [[nodiscard]] std::vector<Placement> place(const align::AlignmentReport& report,
                                             const KnownPoses& given,
                                             const KnownPoses& found_before);

  /// Of `found_before` what stands in the world of those whose poses are given, if there are any.
  [[nodiscard]] KnownPoses settled(const KnownPoses& given, const KnownPoses& found_before) const;

 private:
  std::set<std::string> made_up_;  // the sensors that were placed in a world that was made up
};

}  // namespace roomcast::aligner
