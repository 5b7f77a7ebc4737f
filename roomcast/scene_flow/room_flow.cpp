// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/room_flow.h"

#include <utility>

namespace roomcast::scene_flow {

const FlowField* RoomFlow::take(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm,
                                RoomTime capture_time) {
  auto known = sensors_.find(sensor);
  if (known == sensors_.end() || known->second.flow.lens() != lens) {
    known = sensors_.insert_or_assign(sensor, Sensor{SceneFlow(lens), std::nullopt}).first;
  }
  Sensor& of = known->second;
  if (std::exchange(of.time, capture_time) != capture_time) of.flow.take(depth_mm, capture_time);
  return of.flow.motion();
}

}  // namespace roomcast::scene_flow
