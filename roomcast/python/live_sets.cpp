// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/live_sets.h"

#include <algorithm>
#include <utility>

#include "roomcast/codec/depth_grid_color.h"

namespace roomcast::python {
namespace {

bool same_sensors(const std::vector<recording::SetSensor>& a,
                  const std::vector<recording::SetSensor>& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return one.name == other.name && one.depth == other.depth && one.fps == other.fps &&
           one.expected_error_m == other.expected_error_m;
  });
}

}  // namespace

std::vector<recording::SetSensor> sensors_of(const client::RoomSnapshot& room) {
  std::vector<recording::SetSensor> sensors;
  for (const client::RoomSensor& sensor : room.sensors)
    sensors.push_back(
        {sensor.name, sensor.calibration.depth, sensor.fps, 0.001 * sensor.pose.expected_error_mm});
  return sensors;
}

std::shared_ptr<RoomSet> LiveSets::set_of(const client::RoomSnapshot& room) {
  auto sensors = sensors_of(room);
  if (!sensors_ || !same_sensors(sensors_->list, sensors))
    sensors_ = std::make_shared<const RoomSensors>(std::move(sensors));
  auto set = std::make_shared<RoomSet>();
  set->sensors = sensors_;
  set->may_export = client::check_may_export(room.rights);
  set->set.number = room.newest_set.value;
  for (std::size_t i = 0; i < room.sensors.size(); ++i) {
    const client::RoomSensor& sensor = room.sensors[i];
    if (!sensor.online) continue;
    ++set->sensors_sending;
    if (!sensor.picture) continue;
    recording::SetFrame frame;
    frame.sensor = i;
    frame.pictures = codec::with_color_in_depth_grid({sensor.picture, &sensor.picture->frame});
    if (sensor.pose.is_placed()) frame.world_from_depth = sensor.pose.world_from_depth;
    frame.time = unix_time(room, *sensor.picture);
    set->set.time = std::max(set->set.time, frame.time);
    set->set.frames.push_back(std::move(frame));
  }
  return set;
}

nanoseconds LiveSets::unix_time(const client::RoomSnapshot& room,
                                const client::SensorPicture& picture) const {
  if (!room.clock) return clock_.at(picture.received);
  const HostTime about(picture.capture_time.time_since_epoch() - room.clock->room_minus_host);
  return clock_.at(about - room.clock->drifted(about - room.clock->at));
}

}  // namespace roomcast::python
