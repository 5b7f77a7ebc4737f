// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/room_report.h"

#include <algorithm>

namespace roomcast::viewer {
namespace {

constexpr double kBytesPerMegabyte = 1e6;

std::optional<double> age_ms(const client::RoomSensor& sensor, const client::RoomSnapshot& room,
                             HostTime now) {
  if (!sensor.picture || !room.clock) return std::nullopt;
  const nanoseconds age = room.clock->room_time(now) - sensor.picture->capture_time;
  return std::max(0.0, std::chrono::duration<double, std::milli>(age).count());
}

}  // namespace

void RoomReport::follow(const client::RoomSnapshot& room, HostTime now) {
  bytes_.count(now, room.bytes_received);
  sets_.count(now, room.sets_received);
  figures_.megabytes_per_s = bytes_.per_second() / kBytesPerMegabyte;
  figures_.sets_per_s = sets_.per_second();
  figures_.sensors.clear();
  for (const client::RoomSensor& sensor : room.sensors)
    figures_.sensors.push_back(figures_of(sensor, room, now));
}

SensorFigures RoomReport::figures_of(const client::RoomSensor& sensor,
                                     const client::RoomSnapshot& room, HostTime now) {
  SensorMeters& meters = meters_[sensor.id];
  meters.frames.count(now, sensor.frames_received);
  meters.bytes.count(now, sensor.bytes_received);
  meters.missed.count(now, sensor.frames_missed);
  return {sensor.id,
          meters.frames.per_second(),
          meters.bytes.per_second() / kBytesPerMegabyte,
          meters.missed.per_second(),
          sensor.frames_missed,
          age_ms(sensor, room, now)};
}

}  // namespace roomcast::viewer
