// SPDX-License-Identifier: Apache-2.0
// People in a room here of whom another hub is told, and the newest pose of each; and the other way
// round, people there of whom this one is told. Whoever comes from where is told of is left out, so
// that nobody goes round in circles. Pure.
#pragma once

#include <cstdint>
#include <map>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

class PresenceRelay {
 public:
  /// The room's newest roster. True: there are others to tell of than before.
  bool take(const wire::pb::Roster& roster);
  /// Newest poses in the room; those of people to tell of.
  wire::pb::ViewerPoses take(const wire::pb::ViewerPoses& poses);

  /// Ids are those of the room here; at most kMaxPeopleHere, who came first.
  [[nodiscard]] const wire::pb::PeopleHere& people() const { return people_; }
  /// All that are known.
  [[nodiscard]] wire::pb::ViewerPoses newest_poses() const;

 private:
  wire::pb::PeopleHere people_;
  std::map<std::uint32_t, wire::pb::ViewerPose> poses_;  // of people_
};

/// Who is in the roster of another hub, at which we are this viewer, but for us and who is behind
/// us. Ids are those there.
[[nodiscard]] wire::pb::PeopleHere people_there(const wire::pb::Roster& roster,
                                                std::uint32_t own_viewer_id);

}  // namespace roomcast::hub::federation
