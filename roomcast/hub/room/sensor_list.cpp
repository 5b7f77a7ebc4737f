// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/sensor_list.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/hub/room/pose_rules.h"
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
  RoomSensor sensor{.id = *id, .name = name};
  sensor.pose.world_from_depth = placeholder_pose(id->value);
  sensor.bundles = max_removed_bundle_;
  if (sensor.bundles > 0) sensor.valid_from_bundle = sensor.bundles + 1;
  return &sensors_.emplace(*id, std::move(sensor)).first->second;
}

/// IDs remembered for absent sensors are given to others only when no other ID is free; IDs of
/// sensors with a pose come last.
std::optional<SensorId> SensorList::free_id(const std::string& name) const {
  if (const KnownSensor* earlier = remembered(name);
      earlier != nullptr && !sensors_.contains(earlier->id)) {
    return earlier->id;
  }
  std::optional<SensorId> promised, of_one_with_a_place;
  for (std::uint16_t value = 0; value < wire::kMaxSensors; ++value) {
    const SensorId id{value};
    if (sensors_.contains(id)) continue;
    const KnownSensor* earlier = remembered(id);
    if (earlier == nullptr) return id;
    auto& kept = earlier->pose ? of_one_with_a_place : promised;
    if (!kept) kept = id;
  }
  return promised ? promised : of_one_with_a_place;
}

const KnownSensor* SensorList::remembered(SensorId id) const {
  const auto found = std::ranges::find(remembered_, id, &KnownSensor::id);
  return found == remembered_.end() ? nullptr : &*found;
}

bool SensorList::would_displace(const std::string& name) const {
  const auto id = free_id(name);
  const KnownSensor* earlier = id ? remembered(*id) : nullptr;
  return earlier != nullptr && earlier->name != name && earlier->pose;
}

RoomSensor* SensorList::longest_gone() {
  RoomSensor* longest = nullptr;
  for (RoomSensor& sensor : all()) {
    if (sensor.connection || sensor.pose.is_estimated()) continue;
    if (longest == nullptr || sensor.left_as < longest->left_as) longest = &sensor;
  }
  return longest;
}

void SensorList::remove(const RoomSensor& sensor) {
  ROOMCAST_ASSERT(!sensor.connection);
  max_removed_bundle_ = std::max(max_removed_bundle_, sensor.bundles);
  sensors_.erase(SensorId(sensor.id));
}

bool SensorList::forget(const std::string& name) {
  const bool was_remembered =
      std::erase_if(remembered_, [&](const KnownSensor& s) { return s.name == name; }) > 0;
  const RoomSensor* sensor = find(name);
  if (sensor != nullptr) remove(*sensor);
  return was_remembered || sensor != nullptr;
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
  sensor.health.reset();
  sensor.left_as = ++departures_;
}

}  // namespace roomcast::hub
