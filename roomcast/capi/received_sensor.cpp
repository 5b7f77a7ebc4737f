// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/received_sensor.h"

#include "roomcast/codec/depth_grid_color.h"

namespace roomcast::capi {

std::shared_ptr<const Rays> SensorRays::of(const client::RoomSensor& sensor) {
  Entry& entry = entries_[sensor.id];
  const CameraIntrinsics& camera = sensor.calibration.depth;
  if (!entry.rays || !(entry.camera == camera)) {
    entry = {camera, std::make_shared<const Rays>(ray_table(camera))};
  }
  return entry.rays;
}

std::vector<ReceivedSensor> received_sensors(const client::RoomSnapshot& room, SensorRays& rays) {
  std::vector<ReceivedSensor> received;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (!sensor.online || !sensor.picture) continue;
    const std::shared_ptr<const codec::DecodedFrame> frame(sensor.picture, &sensor.picture->frame);
    received.push_back({&sensor, codec::with_color_in_depth_grid(frame), rays.of(sensor)});
  }
  return received;
}

}  // namespace roomcast::capi
