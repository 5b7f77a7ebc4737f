// SPDX-License-Identifier: Apache-2.0
// RoomFlow: how what each sensor of a room shows moves (SceneFlow). Single-threaded.
#pragma once

#include <map>
#include <optional>

#include "roomcast/core/ids.h"
#include "roomcast/scene_flow/scene_flow.h"

namespace roomcast::scene_flow {

class RoomFlow {
 public:
  /// Takes a sensor's next picture; one of the same time as its last is taken for the same. Null
  /// while nothing moves in it. Valid until the sensor's next picture.
  const FlowField* take(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm,
                        RoomTime capture_time);

  /// Does nothing if there is no such sensor.
  void forget(SensorId sensor) { sensors_.erase(sensor); }

 private:
  struct Sensor {
    SceneFlow flow;
    std::optional<RoomTime> time;
  };
  std::map<SensorId, Sensor> sensors_;
};

}  // namespace roomcast::scene_flow
