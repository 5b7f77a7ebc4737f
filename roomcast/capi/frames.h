// SPDX-License-Identifier: Apache-2.0
// roomcast_frames, of a live room or of a recording, and its sensors as roomcast.h has them.
// Threading: immutable once made.
#pragma once

#include <memory>
#include <vector>

#include "roomcast/capi/received_sensor.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/client/room/room_snapshot.h"

struct roomcast_frames {
  std::shared_ptr<const roomcast::client::RoomSnapshot> room;  // `sensors` points into it
  std::vector<roomcast::capi::ReceivedSensor> sensors;
};

namespace roomcast::capi {

/// Valid as long as the frames. Without pictures if `received.frame` is null.
[[nodiscard]] roomcast_sensor describe(const ReceivedSensor& received);

}  // namespace roomcast::capi
