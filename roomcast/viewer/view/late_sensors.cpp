// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/late_sensors.h"

#include <algorithm>
#include <chrono>

namespace roomcast::viewer {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kLateAfter{0.3};
constexpr double kLateAfterFrames = 2.5;  // a sensor of few frames a second is not late between two

bool sends(const client::RoomSensor& sensor) {
  return sensor.online && sensor.picture && !sensor.is_paused;
}

Seconds late_after(const client::RoomSensor& sensor) {
  if (!(sensor.fps > 0)) return kLateAfter;
  return std::max(kLateAfter, Seconds(kLateAfterFrames / sensor.fps));
}

}  // namespace

std::set<SensorId> late_sensors(const client::RoomSnapshot& room) {
  RoomTime newest = RoomTime::min();
  for (const client::RoomSensor& sensor : room.sensors) {
    if (sends(sensor)) newest = std::max(newest, sensor.picture->capture_time);
  }
  std::set<SensorId> late;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (sends(sensor) && newest - sensor.picture->capture_time > late_after(sensor))
      late.insert(sensor.id);
  }
  return late;
}

}  // namespace roomcast::viewer
