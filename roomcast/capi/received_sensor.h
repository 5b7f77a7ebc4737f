// SPDX-License-Identifier: Apache-2.0
// ReceivedSensor: one sensor's newest frame, with colour in the depth grid and a ray for each
// pixel. Users need not know how the frame was encoded or registered. Threading: immutable once
// made.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/image.h"

namespace roomcast::capi {

using Rays = Image<Eigen::Vector2f>;  // see ray_table()

/// Caches the rays of each sensor's depth camera; computes them again when the intrinsics change.
/// Single-threaded.
class SensorRays {
 public:
  std::shared_ptr<const Rays> of(const client::RoomSensor& sensor);

 private:
  struct Entry {
    CameraIntrinsics camera;
    std::shared_ptr<const Rays> rays;
  };
  std::map<SensorId, Entry> entries_;
};

/// When a frame was captured, as roomcast_sensor has it.
struct FrameStamp {
  std::uint32_t seq = 0;
  std::int64_t capture_ns = 0, capture_utc_ns = 0;
};

struct ReceivedSensor {
  const client::RoomSensor* sensor = nullptr;  // points into the snapshot
  std::shared_ptr<const codec::DecodedFrame> frame;
  std::shared_ptr<const Rays> rays;
  FrameStamp stamp = {};
};

/// The sensors of `room` that are online and have a picture. `room` must outlive the result.
[[nodiscard]] std::vector<ReceivedSensor> received_sensors(const client::RoomSnapshot& room,
                                                           SensorRays& rays);

}  // namespace roomcast::capi
