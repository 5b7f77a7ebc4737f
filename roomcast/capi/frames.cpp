// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/frames.h"

#include <algorithm>

namespace roomcast::capi {

roomcast_sensor describe(const ReceivedSensor& received) {
  const client::RoomSensor& sensor = *received.sensor;
  const CameraIntrinsics& camera = sensor.calibration.depth;
  roomcast_sensor out{};
  out.name = sensor.name.c_str();
  out.id = sensor.id.value;
  out.width = camera.width;
  out.height = camera.height;
  out.fx = camera.fx;
  out.fy = camera.fy;
  out.cx = camera.cx;
  out.cy = camera.cy;
  out.k1 = camera.k1;
  out.k2 = camera.k2;
  out.k3 = camera.k3;
  out.p1 = camera.p1;
  out.p2 = camera.p2;
  std::ranges::copy(row_major_from_transform(sensor.pose.world_from_depth), out.world_from_depth);
  out.placed = sensor.pose.is_placed() ? 1 : 0;
  out.seq = received.stamp.seq;
  out.capture_ns = received.stamp.capture_ns;
  out.capture_utc_ns = received.stamp.capture_utc_ns;
  if (!received.frame) return out;
  const codec::DecodedFrame& frame = *received.frame;
  out.width = frame.depth_mm.width();
  out.height = frame.depth_mm.height();
  out.depth_mm = frame.depth_mm.data();
  if (!frame.color.empty()) {
    out.color_rgb = &frame.color.data()->r;
    out.color_seen = frame.color_seen.data();
  }
  return out;
}

}  // namespace roomcast::capi
