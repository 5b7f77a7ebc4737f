// SPDX-License-Identifier: Apache-2.0
// RoomWorld: the world that a room's sensors are placed in. It stays where it is: when something
// new is known, a sensor whose pose is known already keeps it, bit for bit, and the others are
// placed beside it, so that the rest of the room does not jump; unless what is known now says that
// the pose was off by more than is to be expected. Where no pose is known, alignment makes a world
// up. Such a world ends when somebody says where a sensor stands: those that nothing connects with
// it have no place then, for nobody knows how the two worlds lie. Deterministic. Single-threaded.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/service/placement.h"

namespace roomcast::alignment {

/// Whether a single remembered pose may be what the world holds on to, when nothing better is here.
enum class LoneStoredPose { kDoubted, kTrusted };

class RoomWorld {
 public:
  /// What the report says, moved as a whole so that one of its sensors that has a known pose keeps
  /// it: the one with whom most others keep theirs, too, so that the room stays where it is when a
  /// sensor was moved unnoticed. Poses that were given go before those that were found, and those
  /// before remembered ones, of which two have to agree unless nothing better is here (`lone`).
  /// Whom the report places alone it says nothing of: a remembered one is not placed by it.
  [[nodiscard]] std::vector<Placement> place(const alignment::AlignmentReport& report,
                                             const KnownRoom& known,
                                             LoneStoredPose lone = LoneStoredPose::kTrusted);

  /// Of the poses that were found those in the world of those that were given, if there are any.
  [[nodiscard]] KnownPoses settled(const KnownRoom& known) const;

 private:
  /// The only sensor that stands in the room, in a world that was made up for it alone, when others
  /// stand together without it: it gives way.
  [[nodiscard]] std::optional<std::string> lone_world(const alignment::AlignmentReport& report,
                                                      const KnownRoom& known) const;

  std::set<std::string> provisional_;  // the sensors that were placed in a world that was made up
};

}  // namespace roomcast::alignment
