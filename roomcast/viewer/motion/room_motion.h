// SPDX-License-Identifier: Apache-2.0
// RoomMotion: how what the sensors of a room show moves. MotionFinder finds it in the room's
// snapshots, in the pictures of several sensors at a time. Single-threaded; starts threads of its
// own during a call.
#pragma once

#include <map>
#include <memory>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/ids.h"
#include "roomcast/scene_flow/scene_flow.h"

namespace roomcast::viewer {

/// Of the newest pictures of the sensors; without those in which nothing moves.
using RoomMotion = std::map<SensorId, std::shared_ptr<const scene_flow::FlowField>>;

class MotionFinder {
 public:
  /// Call it with each snapshot: motion is found from two pictures of a sensor in a row.
  RoomMotion find(const client::RoomSnapshot& room);

 private:
  struct Sensor {
    scene_flow::SceneFlow flow;
    std::shared_ptr<const client::SensorPicture> picture = nullptr;  // the last that was taken
    std::shared_ptr<const scene_flow::FlowField> motion = nullptr;   // of it
  };
  Sensor& known(const client::RoomSensor& sensor);
  void forget_others(const client::RoomSnapshot& room);

  std::map<SensorId, Sensor> sensors_;
};

}  // namespace roomcast::viewer
