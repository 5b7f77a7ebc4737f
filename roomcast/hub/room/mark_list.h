// SPDX-License-Identifier: Apache-2.0
// MarkList: the marks of a room, within the limits of docs/spec/wire.md §4. Pure; single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class MarkList {
 public:
  /// Takes the marks that the store has; those beyond a limit are left out.
  void remember(std::vector<wire::pb::Mark> marks);

  /// Adds a mark that wire::check_mark accepts; returns it with its ID. kUnavailable: a limit of
  /// the room or of the author is reached; the sentence is for people.
  [[nodiscard]] Result<wire::pb::Mark> add(wire::pb::Mark mark);

  /// Whose marks remove() takes away.
  struct Remover {
    std::uint64_t author_tag = 0;  // 0: nobody's
    bool may_remove_all = false;   // an admin
  };
  /// Returns the IDs of the marks that are gone now.
  [[nodiscard]] std::vector<std::uint32_t> remove(std::span<const std::uint32_t> ids,
                                                  Remover remover);

  [[nodiscard]] std::size_t size() const { return marks_.size(); }
  /// All marks, oldest first, in messages of which none is too large; none without marks.
  [[nodiscard]] std::vector<wire::pb::Control> messages() const;

 private:
  std::map<std::uint32_t, wire::pb::Mark> marks_;  // by ID
  std::map<std::uint64_t, int> of_author_;         // marks, by author_tag
  int points_ = 0;
  std::uint32_t next_id_ = 1;
};

}  // namespace roomcast::hub
