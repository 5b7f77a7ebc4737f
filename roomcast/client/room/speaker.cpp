// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/speaker.h"

#include <algorithm>

#include "roomcast/wire/audio_header.h"

namespace roomcast::client {
namespace {

/// Null: not in the room.
const RoomSensor* sensor_that_is_heard(const RoomSnapshot& room, ViewerId speaker) {
  const auto id = wire::sensor_of(speaker);
  if (!id) return nullptr;
  const auto found = std::ranges::find(room.sensors, *id, &RoomSensor::id);
  return found == room.sensors.end() ? nullptr : &*found;
}

const RoomPerson* person_who_is_heard(const RoomSnapshot& room, ViewerId speaker) {
  const auto found = std::ranges::find(room.people, speaker, &RoomPerson::id);
  return found == room.people.end() ? nullptr : &*found;
}

}  // namespace

std::optional<SensorId> sensor_of_speaker(ViewerId speaker) {
  return wire::sensor_of(speaker);
}

std::optional<RigidTransform> world_from_speaker(const RoomSnapshot& room, ViewerId speaker) {
  if (const RoomSensor* sensor = sensor_that_is_heard(room, speaker)) {
    // A sensor's frame has y down and z ahead.
    const RigidTransform depth_from_head{Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix(),
                                         Eigen::Vector3d::Zero()};
    return sensor->pose.world_from_depth * depth_from_head;
  }
  const RoomPerson* person = person_who_is_heard(room, speaker);
  if (person == nullptr || !person->pose) return std::nullopt;
  return person->pose->world_from_head;
}

bool speaker_is_here(const RoomSnapshot& room, ViewerId speaker) {
  return sensor_that_is_heard(room, speaker) != nullptr ||
         person_who_is_heard(room, speaker) != nullptr;
}

std::string speaker_name(const RoomSnapshot& room, ViewerId speaker) {
  if (const RoomSensor* sensor = sensor_that_is_heard(room, speaker)) return sensor->name;
  const RoomPerson* person = person_who_is_heard(room, speaker);
  return person == nullptr ? "" : person->name;
}

}  // namespace roomcast::client
