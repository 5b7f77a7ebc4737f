// SPDX-License-Identifier: Apache-2.0
// MarkStore: the marks of each room, kept across restarts of the hub. Threading: as Database.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/store/database.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class MarkStore {
 public:
  explicit MarkStore(Database& database) : database_(database) {}

  /// The marks of one room, oldest first. Invalid entries are left out.
  [[nodiscard]] Result<std::vector<wire::pb::Mark>> load(const std::string& room) const;
  /// Adds marks by their IDs and deletes others, all or nothing.
  [[nodiscard]] Status save(const std::string& room, std::span<const wire::pb::Mark> added,
                            std::span<const std::uint32_t> removed);
  /// Deletes all marks of a room.
  [[nodiscard]] Status forget(const std::string& room);

 private:
  [[nodiscard]] bool write(const std::string& room, std::span<const wire::pb::Mark> added,
                           std::span<const std::uint32_t> removed) const;
  Database& database_;
};

}  // namespace roomcast::hub
