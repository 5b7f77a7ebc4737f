// SPDX-License-Identifier: Apache-2.0
// The functions of roomcast.h that read recordings.
#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "roomcast/capi/c_border.h"
#include "roomcast/capi/frames.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

struct roomcast_reader {
  std::mutex mutex;
  std::unique_ptr<roomcast::recording::FrameSetReader> sets;
  roomcast::capi::SensorRays rays;
};

namespace {

using namespace roomcast;

using capi::guarded;
using capi::say;
using recording::SetSensor;

client::RoomSensor room_sensor(const SetSensor& recorded, std::size_t number) {
  client::RoomSensor sensor;
  sensor.id = SensorId{static_cast<std::uint16_t>(number + 1)};
  sensor.name = recorded.name;
  sensor.online = true;
  sensor.fps = recorded.fps;
  sensor.calibration.depth = recorded.depth;
  return sensor;
}

roomcast_frames* frames_of(roomcast_reader& reader, const recording::FrameSet& set) {
  auto room = std::make_shared<client::RoomSnapshot>();
  const auto& sensors = reader.sets->sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i)
    room->sensors.push_back(room_sensor(sensors[i], i));
  auto frames = std::make_unique<roomcast_frames>();
  const nanoseconds began = reader.sets->began_at();
  for (const recording::SetFrame& frame : set.frames) {
    client::RoomSensor& sensor = room->sensors[frame.sensor];
    if (frame.world_from_depth)
      sensor.pose = {.world_from_depth = *frame.world_from_depth,
                     .source = PoseSource::kGiven,
                     .state = PoseState::kValid};
    const std::int64_t utc = began.count() > 0 ? (began + frame.time).count() : 0;
    frames->sensors.push_back({&sensor,
                               frame.pictures,
                               reader.rays.of(sensor),
                               {static_cast<std::uint32_t>(set.number), frame.time.count(), utc}});
  }
  frames->room = std::move(room);
  return frames.release();
}

}  // namespace

extern "C" {

roomcast_reader* roomcast_open(const char* path, char* error, size_t error_size) {
  return guarded<roomcast_reader*>(nullptr, error, error_size, [&]() -> roomcast_reader* {
    auto opened = recording::open_frame_sets(capi::text(path));
    if (!opened) {
      say(opened.error().message, error, error_size);
      return nullptr;
    }
    auto reader = std::make_unique<roomcast_reader>();
    reader->sets = *std::move(opened);
    return reader.release();
  });
}

roomcast_frames* roomcast_next_frames(roomcast_reader* reader, char* error, size_t error_size) {
  say("", error, error_size);
  return guarded<roomcast_frames*>(nullptr, error, error_size, [&]() -> roomcast_frames* {
    const std::lock_guard lock(reader->mutex);
    recording::FrameSet set;
    const auto more = reader->sets->next(set);
    if (!more) say(more.error().message, error, error_size);
    return more && *more ? frames_of(*reader, set) : nullptr;
  });
}

size_t roomcast_recorded_sensor_count(roomcast_reader* reader) {
  return reader->sets->sensors().size();
}

int roomcast_get_recorded_sensor(roomcast_reader* reader, size_t number, roomcast_sensor* sensor) {
  const auto& sensors = reader->sets->sensors();
  if (number >= sensors.size()) return 0;
  return guarded(0, nullptr, 0, [&] {
    const client::RoomSensor described = room_sensor(sensors[number], number);
    roomcast_sensor out = capi::describe({&described, nullptr, nullptr});
    out.name = sensors[number].name.c_str();  // which lives as long as the reader
    capi::copy_known_part(out, *sensor);
    return 1;
  });
}

int64_t roomcast_recorded_length_ns(roomcast_reader* reader) {
  return reader->sets->length().count();
}

int roomcast_may_export_recorded(roomcast_reader* reader, char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const Status allowed = recording::check_may_be_exported(*reader->sets);
    if (!allowed) say(allowed.error().message, error, error_size);
    return allowed ? 1 : 0;
  });
}

void roomcast_close(roomcast_reader* reader) {
  delete reader;
}

}  // extern "C"
