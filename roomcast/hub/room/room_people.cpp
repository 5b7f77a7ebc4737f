// SPDX-License-Identifier: Apache-2.0
// People who watch a Room at other hubs: which clients may report them, and which clients are sent
// the poses of the people here.
#include <algorithm>
#include <iterator>
#include <utility>

#include "roomcast/hub/room/room.h"

namespace roomcast::hub {

namespace pb = wire::pb;

/// Viewers that are hubs may, and aligners, because the backplane joins as one.
bool Room::may_report_people(ConnectionId from) const {
  const auto viewer = viewers_.find(from);
  if (viewer != viewers_.end()) return viewer->second.relays;
  return std::ranges::find(aligners_, from) != aligners_.end();
}

RoomActions Room::take_people(ConnectionId from, const pb::PeopleHere& people, RoomTime now) {
  RemotePresence::Reporter reporter{from};
  if (const auto viewer = viewers_.find(from); viewer != viewers_.end()) {
    reporter.viewer = viewer->second.id;
    if (!viewer->second.people.take(1, HostTime(now.time_since_epoch()))) {
      return refuse(from, pb::ERROR_TOO_FAST, "this hub reports its people too often", now);
    }
  }
  RoomActions out;
  const auto change =
      remote_presence_.report(reporter, people, [this] { return ViewerId{next_viewer_id_++}; });
  if (forget_people(change)) send_roster_when_due(now, out);
  return out;
}

void Room::take_poses(ConnectionId from, const pb::ViewerPoses& poses, RoomTime now) {
  for (const pb::ViewerPose& pose : poses.poses()) {
    const auto person = remote_presence_.find(from, pose.viewer_id());
    if (person) poses_.set(*person, pose, now);
  }
}

/// Removes the poses of people who have left. True: the roster has changed.
bool Room::forget_people(const RemotePresence::Change& change) {
  for (const ViewerId gone : change.gone) poses_.forget(gone);
  return change.has_changed;
}

/// All viewers, and the backplane's aligners.
std::vector<ConnectionId> Room::readers_of_poses() const {
  std::vector<ConnectionId> connections = viewer_connections();
  std::ranges::copy(backplane_aligners_, std::back_inserter(connections));
  return connections;
}

}  // namespace roomcast::hub
