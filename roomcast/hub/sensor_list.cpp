// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/sensor_list.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

SensorId wire_id(std::uint32_t id) {
  return SensorId{static_cast<std::uint16_t>(std::min<std::uint32_t>(id, wire::kMaxSensors))};
}

const KnownSensor* SensorList::remembered(const std::string& name) const {
  const auto found = std::ranges::find(remembered_, name, &KnownSensor::name);
  return found == remembered_.end() ? nullptr : &*found;
}

RoomSensor* SensorList::add(const std::string& name) {
  const auto id = free_id(name);
  if (!id) return nullptr;
  RoomSensor sensor{.id = *id, .name = name, .place = SensorPlace::guessed(id->value)};
  return &sensors_.emplace(*id, std::move(sensor)).first->second;
}

/// Ids of those who may come back are taken by others only when nothing else is left.
std::optional<SensorId> SensorList::free_id(const std::string& name) const {
  if (const KnownSensor* earlier = remembered(name);
      earlier != nullptr && !sensors_.contains(earlier->id)) {
    return earlier->id;
  }
  std::optional<SensorId> promised;
  for (std::uint16_t value = 0; value < wire::kMaxSensors; ++value) {
    const SensorId id{value};
    if (sensors_.contains(id)) continue;
    if (!is_remembered(id)) return id;
    if (!promised) promised = id;
  }
  return promised;
}

bool SensorList::is_remembered(SensorId id) const {
  return std::ranges::find(remembered_, id, &KnownSensor::id) != remembered_.end();
}

RoomSensor* SensorList::find(const std::string& name) {
  const auto found = std::ranges::find(all(), name, &RoomSensor::name);
  return found == all().end() ? nullptr : &*found;
}

RoomSensor* SensorList::find(SensorId id) {
  const auto found = sensors_.find(id);
  return found == sensors_.end() ? nullptr : &found->second;
}

RoomSensor* SensorList::find(ConnectionId connection) {
  const auto found = by_connection_.find(connection);
  return found == by_connection_.end() ? nullptr : find(found->second);
}

void SensorList::connect(RoomSensor& sensor, ConnectionId connection) {
  disconnect(sensor);
  sensor.connection = connection;
  by_connection_[connection] = sensor.id;
}

void SensorList::disconnect(RoomSensor& sensor) {
  if (!sensor.connection) return;
  by_connection_.erase(*sensor.connection);
  sensor.connection.reset();
}

}  // namespace roomcast::hub
