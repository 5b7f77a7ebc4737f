// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/room_store.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace roomcast::hub {

Result<std::vector<RoomSettings>> RoomStore::load() const {
  Statement rows(database_, "SELECT settings FROM rooms ORDER BY name");
  std::vector<RoomSettings> rooms;
  while (rows.next()) {
    const auto json = nlohmann::json::parse(rows.text(0), nullptr, false);
    if (auto settings = changed({}, json)) rooms.push_back(*std::move(settings));
  }
  if (!rows.finished()) return database_.failure("cannot read the stored rooms");
  return rooms;
}

Status RoomStore::save(const RoomSettings& settings) {
  Statement row(database_, "INSERT OR REPLACE INTO rooms VALUES (?1, ?2)");
  if (row.bind(1, settings.name).bind(2, to_json(settings).dump()).run()) return {};
  return database_.failure("cannot store a room");
}

Status RoomStore::forget(const std::string& room) {
  if (Statement(database_, "DELETE FROM rooms WHERE name = ?1").bind(1, room).run()) return {};
  return database_.failure("cannot forget a room");
}

}  // namespace roomcast::hub
