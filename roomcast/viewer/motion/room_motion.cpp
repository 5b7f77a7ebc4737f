// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/motion/room_motion.h"

#include <algorithm>
#include <vector>

#include "roomcast/core/parallel_rows.h"

namespace roomcast::viewer {

MotionFinder::Sensor& MotionFinder::known(const client::RoomSensor& sensor) {
  const CameraIntrinsics& lens = sensor.calibration.depth;
  const auto found = sensors_.find(sensor.id);
  if (found != sensors_.end() && found->second.flow.lens() == lens) return found->second;
  return sensors_.insert_or_assign(sensor.id, Sensor{scene_flow::SceneFlow(lens)}).first->second;
}

void MotionFinder::forget_others(const client::RoomSnapshot& room) {
  std::erase_if(sensors_, [&room](const auto& known) {
    return std::ranges::find(room.sensors, known.first, &client::RoomSensor::id) ==
           room.sensors.end();
  });
}

RoomMotion MotionFinder::find(const client::RoomSnapshot& room) {
  forget_others(room);
  std::vector<Sensor*> fresh;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (!sensor.picture) continue;
    Sensor& of = known(sensor);
    if (of.picture == sensor.picture) continue;
    of.picture = sensor.picture;
    fresh.push_back(&of);
  }
  const auto count = static_cast<int>(fresh.size());
  for_each_row(count, std::clamp(count, 1, thread_count(0)), [&fresh](int i) {
    Sensor& sensor = *fresh[static_cast<std::size_t>(i)];
    sensor.flow.take(sensor.picture->frame.depth_mm, sensor.picture->capture_time);
    const scene_flow::FlowField* moves = sensor.flow.motion();
    sensor.motion =
        moves == nullptr ? nullptr : std::make_shared<const scene_flow::FlowField>(*moves);
  });
  RoomMotion motion;
  for (const auto& [id, sensor] : sensors_) {
    if (sensor.motion) motion.emplace(id, sensor.motion);
  }
  return motion;
}

}  // namespace roomcast::viewer
