// SPDX-License-Identifier: Apache-2.0
// SensorStore: which sensors a room has had, under which ids, and where alignment found that they
// stand; kept in an SQLite file, so that a room is itself again right after its hub starts. Poses
// that sensors bring themselves are not kept. A write does not wait for the disk (write-ahead log,
// no sync): after a power cut the newest may be missing, which costs a sensor its id or has
// alignment find its pose again. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/known_sensor.h"

struct sqlite3;

namespace roomcast::hub {

class SensorStore {
 public:
  /// Makes the file where there is none. kUnavailable: it cannot be opened, is no such file or is
  /// of a later version; the sentence says which.
  static Result<std::unique_ptr<SensorStore>> open(const std::filesystem::path& file);
  ~SensorStore();
  SensorStore(const SensorStore&) = delete;
  SensorStore& operator=(const SensorStore&) = delete;

  /// Of one room. Entries that make no sense are left out.
  [[nodiscard]] Result<std::vector<KnownSensor>> load(const std::string& room) const;

  /// Adds or replaces, by name. Who had one of the ids before is forgotten.
  [[nodiscard]] Status save(const std::string& room, std::span<const KnownSensor> sensors);

 private:
  explicit SensorStore(sqlite3* database) : database_(database) {}
  [[nodiscard]] Status run(const char* sql);
  [[nodiscard]] Result<int> version() const;
  sqlite3* database_;
};

}  // namespace roomcast::hub
