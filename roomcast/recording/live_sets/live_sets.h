// SPDX-License-Identifier: Apache-2.0
// LiveSets: frame sets of a running room, made of the snapshots of a Subscriber. Room time becomes
// time of day by this machine's clock, read once. Single-threaded.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/recorder/unix_clock.h"

namespace roomcast::recording {

struct LiveSet {
  std::vector<SetSensor> sensors;   // as sensors_of()
  FrameSet set;                     // times since 1970-01-01 UTC
  std::size_t sensors_sending = 0;  // those that a complete set has
};

class LiveSets {
 public:
  /// The newest pictures of all sensors that are online and have sent any. An unchanged picture is
  /// the same object in later sets.
  [[nodiscard]] LiveSet set_of(const client::RoomSnapshot& room);

 private:
  struct InGrid {  // colour is reduced once for each picture
    std::shared_ptr<const client::SensorPicture> picture;
    std::shared_ptr<const codec::DecodedFrame> in_grid;
  };
  [[nodiscard]] nanoseconds unix_time(const client::RoomSnapshot& room,
                                      const client::SensorPicture& picture) const;

  const UnixClock clock_;
  std::map<SensorId, InGrid> newest_;
};

/// The sensors of a room that are online or have been, by ID.
[[nodiscard]] std::vector<SetSensor> sensors_of(const client::RoomSnapshot& room);

}  // namespace roomcast::recording
