// SPDX-License-Identifier: Apache-2.0
// SensorList: the sensors that a room has seen, by name, id and connection. A name keeps its id,
// also over a restart of the hub when its earlier ids are remembered, unless it is gone, has no
// place, and others need the room. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <unordered_map>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/key_request_pace.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/room/sensor_place.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// What a message calls a sensor; an id that none can have for one that is too large.
[[nodiscard]] SensorId wire_id(std::uint32_t id);

struct RoomSensor {
  SensorId id;
  std::string name;
  std::optional<ConnectionId> connection = {};  // while online
  wire::pb::SensorRole description = {};        // as last joined
  SensorPlace place = {};
  std::optional<wire::pb::Control> bundle = {};  // the newest since it joined
  std::uint32_t bundles = 0;                     // that it has sent, ever
  std::size_t bundle_hash = 0;                   // of the newest
  std::optional<std::size_t> verified_by = {};   // hash of the bundle that its place was found from
  std::string token_id = {};                     // that it came with
  std::uint64_t left_as = 0;                     // of all that left, in their order
  KeyRequestPace key_pace = {};
  SensorStats stats = {};  // what changes with its frames
};

class SensorList {
 public:
  /// Who was here before the hub was started. Call it first.
  void remember(std::vector<KnownSensor> sensors) { remembered_ = std::move(sensors); }

  /// What is remembered under this name, if anything.
  [[nodiscard]] const KnownSensor* remembered(const std::string& name) const;

  /// A sensor whose name is new here. It gets the id that it had, or else the lowest that nobody
  /// has, or else one of who had no place. Null: wire::kMaxSensors are here.
  RoomSensor* add(const std::string& name);
  /// Would a new one take the id of somebody who was here before, and had a place?
  [[nodiscard]] bool would_displace(const std::string& name) const;

  /// Of those who are offline and have no place that was found for them: who left first. Null:
  /// none.
  [[nodiscard]] RoomSensor* longest_gone();
  /// It was never here. Not for one that is online.
  void remove(const RoomSensor& sensor);
  /// As remove(), and what is remembered under this name. False: nothing was known of it.
  bool forget(const std::string& name);

  /// Null: there is none of this name or id, or none behind this connection.
  [[nodiscard]] RoomSensor* find(const std::string& name);
  [[nodiscard]] RoomSensor* find(SensorId id);
  [[nodiscard]] RoomSensor* find(ConnectionId connection);

  /// It is online now, behind this connection and no other.
  void connect(RoomSensor& sensor, ConnectionId connection);
  void disconnect(RoomSensor& sensor);

  [[nodiscard]] std::size_t count() const { return sensors_.size(); }
  [[nodiscard]] std::size_t online_count() const { return by_connection_.size(); }
  /// In the order of their ids.
  [[nodiscard]] auto all() { return std::views::values(sensors_); }
  [[nodiscard]] auto all() const { return std::views::values(sensors_); }

 private:
  [[nodiscard]] std::optional<SensorId> free_id(const std::string& name) const;
  [[nodiscard]] const KnownSensor* remembered(SensorId id) const;

  std::map<SensorId, RoomSensor> sensors_;
  std::unordered_map<ConnectionId, SensorId> by_connection_;
  std::vector<KnownSensor> remembered_;
  std::uint64_t departures_ = 0;
  std::uint32_t bundles_of_the_removed_ = 0;  // the highest number: what is found from it is old
};

}  // namespace roomcast::hub
