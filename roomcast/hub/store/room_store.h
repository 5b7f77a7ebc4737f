// SPDX-License-Identifier: Apache-2.0
// RoomStore: the rooms that admins opened or changed, kept across restarts. Threading: as Database.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/store/database.h"

namespace roomcast::hub {

class RoomStore {
 public:
  explicit RoomStore(Database& database) : database_(database) {}

  /// In the order of the names. Invalid entries are left out.
  [[nodiscard]] Result<std::vector<RoomSettings>> load() const;
  /// Adds or replaces.
  [[nodiscard]] Status save(const RoomSettings& settings);
  [[nodiscard]] Status forget(const std::string& room);

 private:
  Database& database_;
};

}  // namespace roomcast::hub
