// SPDX-License-Identifier: Apache-2.0
// LiveRoomSets: the frame sets of a running room as Python sees them. Single-threaded.
#pragma once

#include <memory>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/python/room_sets.h"
#include "roomcast/recording/live_sets/live_sets.h"

namespace roomcast::python {

class LiveRoomSets {
 public:
  /// The newest pictures of all sensors that are online and have sent any.
  [[nodiscard]] std::shared_ptr<RoomSet> set_of(const client::RoomSnapshot& room);

 private:
  recording::LiveSets sets_;
  std::shared_ptr<const RoomSensors> sensors_;  // those of the last set
};

}  // namespace roomcast::python
