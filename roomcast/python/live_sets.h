// SPDX-License-Identifier: Apache-2.0
// LiveSets: frame sets of a running room, made of the snapshots of a Subscriber. Room time becomes
// time of day by this machine's clock, read once. Single-threaded.
#pragma once

#include <memory>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/python/room_sets.h"
#include "roomcast/recording/recorder/unix_clock.h"

namespace roomcast::python {

class LiveSets {
 public:
  /// The newest pictures of all sensors that are online and have sent any.
  [[nodiscard]] std::shared_ptr<RoomSet> set_of(const client::RoomSnapshot& room);

 private:
  [[nodiscard]] nanoseconds unix_time(const client::RoomSnapshot& room,
                                      const client::SensorPicture& picture) const;

  const recording::UnixClock clock_;
  std::shared_ptr<const RoomSensors> sensors_;  // those of the last set
};

/// The sensors of a room that are online or have been, by ID.
[[nodiscard]] std::vector<recording::SetSensor> sensors_of(const client::RoomSnapshot& room);

}  // namespace roomcast::python
