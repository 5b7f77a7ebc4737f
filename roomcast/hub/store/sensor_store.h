// SPDX-License-Identifier: Apache-2.0
// SensorStore: which sensors a room has had, under which ids, and where alignment found that they
// stand, so that a room is itself again right after its hub starts. Poses that sensors bring
// themselves are not kept. Threading: the database's.
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

  /// Of one room. Entries that make no sense are left out.
  [[nodiscard]] Result<std::vector<KnownSensor>> load(const std::string& room) const;

  /// Adds or replaces, by name; all or none. Who had one of the ids before is forgotten.
  [[nodiscard]] Status save(const std::string& room, std::span<const KnownSensor> sensors);

  /// All of a room.
  [[nodiscard]] Status forget(const std::string& room);
  /// One. kNotFound: this room has had no such sensor.
  [[nodiscard]] Status forget(const std::string& room, const std::string& sensor);

 private:
  Database& database_;
};

}  // namespace roomcast::hub
