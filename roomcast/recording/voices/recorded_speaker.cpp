// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/recorded_speaker.h"

#include <algorithm>

#include <fmt/format.h>

#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::recording {
namespace {

std::string name_in(const wire::pb::Roster& roster, ViewerId speaker) {
  if (const auto sensor = wire::sensor_of(speaker)) {
    for (const auto& entry : roster.sensors())
      if (entry.id() == sensor->value) return entry.name();
  }
  for (const auto& entry : roster.viewers())
    if (entry.id() == speaker.value) return entry.name();
  return "";
}

}  // namespace

std::string recorded_name(const RoomRecording& recording, ViewerId speaker, nanoseconds log_time) {
  std::string name;
  for (const RecordedRoster& moment : recording.rosters()) {
    if (const std::string found = name_in(moment.roster, speaker); !found.empty()) name = found;
    if (moment.time > log_time && !name.empty()) break;
  }
  if (!name.empty()) return name;
  const auto sensor = wire::sensor_of(speaker);
  return sensor ? fmt::format("sensor {}", sensor->value) : fmt::format("viewer {}", speaker.value);
}

std::optional<Eigen::Vector3d> recorded_place(const RoomRecording& recording, SensorId sensor,
                                              nanoseconds log_time) {
  std::optional<Eigen::Vector3d> place;
  for (const RecordedRoster& moment : recording.rosters()) {
    if (moment.time > log_time && place) break;
    const auto& sensors = moment.roster.sensors();
    const auto entry = std::ranges::find_if(
        sensors, [sensor](const auto& known) { return known.id() == sensor.value; });
    if (entry == sensors.end()) continue;
    if (const auto pose = wire::read_pose(*entry)) place = pose->world_from_depth.translation_m;
  }
  return place;
}

}  // namespace roomcast::recording
