// SPDX-License-Identifier: Apache-2.0
// SensorStore: the sensors of each room with their IDs and estimated poses, so that a room is
// restored when its hub starts. Poses supplied by sensors are not stored. Threading: as Database.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/hub/store/database.h"

namespace roomcast::hub {

class SensorStore {
 public:
  explicit SensorStore(Database& database) : database_(database) {}

  /// The sensors of one room. Invalid entries are left out.
  [[nodiscard]] Result<std::vector<KnownSensor>> load(const std::string& room) const;

  /// Adds or replaces sensors by name, all or none. Deletes other sensors with one of these IDs.
  [[nodiscard]] Status save(const std::string& room, std::span<const KnownSensor> sensors);

  /// Deletes all sensors of a room.
  [[nodiscard]] Status forget(const std::string& room);
  /// Deletes one sensor. kNotFound: the room has had no such sensor.
  [[nodiscard]] Status forget(const std::string& room, const std::string& sensor);

 private:
  Database& database_;
};

}  // namespace roomcast::hub
