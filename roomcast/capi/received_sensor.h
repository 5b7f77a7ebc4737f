// SPDX-License-Identifier: Apache-2.0
// ReceivedSensor: one sensor's newest picture for those who know nothing of how it came: colour in
// the grid of depth, and the ray of every pixel. Threading: plain data, shared once made.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/image.h"

namespace roomcast::capi {

using Rays = Image<Eigen::Vector2f>;  // as ray_table() makes them

/// The rays of every sensor's depth camera, worked out when its calibration is new.
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

struct ReceivedSensor {
  const client::RoomSensor* sensor = nullptr;  // of the snapshot it was taken from
  std::shared_ptr<const codec::DecodedFrame> frame;
  std::shared_ptr<const Rays> rays;
};

/// Those that are there and have a picture, by id. The snapshot has to stay as long as they do.
[[nodiscard]] std::vector<ReceivedSensor> received_sensors(const client::RoomSnapshot& room,
                                                           SensorRays& rays);

}  // namespace roomcast::capi
