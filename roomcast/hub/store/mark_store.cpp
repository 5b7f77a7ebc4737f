// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/mark_store.h"

#include <utility>

#include "roomcast/wire/mark_check.h"

namespace roomcast::hub {

namespace pb = wire::pb;

Result<std::vector<pb::Mark>> MarkStore::load(const std::string& room) const {
  Statement rows(database_, "SELECT id, mark FROM marks WHERE room = ?1 ORDER BY id");
  rows.bind(1, room);
  std::vector<pb::Mark> marks;
  while (rows.next()) {
    const std::string_view bytes = rows.blob(1);
    pb::Mark mark;
    const bool is_read = mark.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
    if (is_read && std::int64_t{mark.id()} == rows.integer(0) && wire::check_mark(mark)) {
      marks.push_back(std::move(mark));
    }
  }
  if (!rows.finished()) return database_.failure("cannot read the stored marks");
  return marks;
}

bool MarkStore::write(const std::string& room, std::span<const pb::Mark> added,
                      std::span<const std::uint32_t> removed) const {
  for (const pb::Mark& mark : added) {
    const std::string bytes = mark.SerializeAsString();
    Statement row(database_, "INSERT OR REPLACE INTO marks VALUES (?1, ?2, ?3)");
    row.bind(1, room).bind(2, std::int64_t{mark.id()}).bind_blob(3, bytes.data(), bytes.size());
    if (!row.run()) return false;
  }
  for (const std::uint32_t id : removed) {
    Statement row(database_, "DELETE FROM marks WHERE room = ?1 AND id = ?2");
    if (!row.bind(1, room).bind(2, std::int64_t{id}).run()) return false;
  }
  return true;
}

Status MarkStore::save(const std::string& room, std::span<const pb::Mark> added,
                       std::span<const std::uint32_t> removed) {
  return database_.in_transaction([&]() -> Status {
    if (write(room, added, removed)) return {};
    return database_.failure("cannot store a mark");
  });
}

Status MarkStore::forget(const std::string& room) {
  if (Statement(database_, "DELETE FROM marks WHERE room = ?1").bind(1, room).run()) return {};
  return database_.failure("cannot forget the marks of a room");
}

}  // namespace roomcast::hub
