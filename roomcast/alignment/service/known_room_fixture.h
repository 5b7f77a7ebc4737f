// SPDX-License-Identifier: Apache-2.0
// Rosters for tests of placement: sensors that are connected, by the source of their poses.
#pragma once

#include "roomcast/alignment/service/placement.h"

namespace roomcast::alignment {

inline void add_poses(KnownRoom& room, PoseSource source, const KnownPoses& poses) {
  for (const auto& [sensor, pose] : poses)
    room[sensor].pose = {.world_from_depth = pose, .source = source};
}

inline KnownRoom room_of(PoseSource source, const KnownPoses& poses) {
  KnownRoom room;
  add_poses(room, source, poses);
  return room;
}

inline KnownRoom given_room(const KnownPoses& given, const KnownPoses& stored = {}) {
  KnownRoom room = room_of(PoseSource::kGiven, given);
  add_poses(room, PoseSource::kStored, stored);
  return room;
}

inline KnownRoom stored_room(const KnownPoses& poses) {
  return room_of(PoseSource::kStored, poses);
}

}  // namespace roomcast::alignment
