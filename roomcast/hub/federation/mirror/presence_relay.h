// SPDX-License-Identifier: Apache-2.0
// PresenceRelay: the people in a room here that are reported to another hub, with the newest pose
// of each. People are not reported back to their origin, so that no report circulates. Pure.
#pragma once

#include <cstdint>
#include <map>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

class PresenceRelay {
 public:
  /// Takes the room's newest roster. True: the people to report have changed.
  bool take(const wire::pb::Roster& roster);
  /// Takes newest poses in the room; returns those of the people to report.
  wire::pb::ViewerPoses take(const wire::pb::ViewerPoses& poses);

  /// IDs are those of the room here; at most kMaxPeopleHere, lowest IDs first.
  [[nodiscard]] const wire::pb::PeopleHere& people() const { return people_; }
  /// All known poses.
  [[nodiscard]] wire::pb::ViewerPoses newest_poses() const;

 private:
  wire::pb::PeopleHere people_;
  std::map<std::uint32_t, wire::pb::ViewerPose> poses_;  // of people_
};

/// The people in the roster of another hub, at which we are viewer `own_viewer_id`, except for us
/// and the people behind us. IDs are those of that hub.
[[nodiscard]] wire::pb::PeopleHere people_there(const wire::pb::Roster& roster,
                                                std::uint32_t own_viewer_id);

}  // namespace roomcast::hub::federation
