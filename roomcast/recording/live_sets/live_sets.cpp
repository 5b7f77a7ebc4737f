// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/live_sets/live_sets.h"

#include <algorithm>
#include <utility>

#include "roomcast/codec/depth_grid_color.h"

namespace roomcast::recording {

std::vector<SetSensor> sensors_of(const client::RoomSnapshot& room) {
  std::vector<SetSensor> sensors;
  for (const client::RoomSensor& sensor : room.sensors)
    sensors.push_back(
        {sensor.name, sensor.calibration.depth, sensor.fps, 0.001 * sensor.pose.expected_error_mm});
  return sensors;
}

LiveSet LiveSets::set_of(const client::RoomSnapshot& room) {
  LiveSet live;
  live.sensors = sensors_of(room);
  live.set.number = room.newest_set.value;
  std::map<SensorId, InGrid> newest;
  for (std::size_t i = 0; i < room.sensors.size(); ++i) {
    const client::RoomSensor& sensor = room.sensors[i];
    if (!sensor.online) continue;
    ++live.sensors_sending;
    if (!sensor.picture) continue;
    InGrid& known = newest[sensor.id] = std::move(newest_[sensor.id]);
    if (known.picture != sensor.picture) {
      known = {sensor.picture,
               codec::with_color_in_depth_grid({sensor.picture, &sensor.picture->frame})};
    }
    SetFrame frame;
    frame.sensor = i;
    frame.pictures = known.in_grid;
    if (sensor.pose.is_placed()) frame.world_from_depth = sensor.pose.world_from_depth;
    frame.time = unix_time(room, *sensor.picture);
    live.set.time = std::max(live.set.time, frame.time);
    live.set.frames.push_back(std::move(frame));
  }
  newest_ = std::move(newest);
  return live;
}

nanoseconds LiveSets::unix_time(const client::RoomSnapshot& room,
                                const client::SensorPicture& picture) const {
  return room.clock ? clock_.at(picture.capture_time, *room.clock) : clock_.at(picture.received);
}

}  // namespace roomcast::recording
