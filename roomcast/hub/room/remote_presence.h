// SPDX-License-Identifier: Apache-2.0
// RemotePresence: who watches a room at other hubs, as those tell: a viewer that is a hub tells
// who is there, the backplane who is at the hubs beside or before this one. Each person gets an id
// of this room, so that nobody speaks for one of whom another hub has told. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class RemotePresence {
 public:
  using NewId = std::function<ViewerId()>;
  struct Teller {
    ConnectionId connection;
    ViewerId viewer{};  // that it is here; 0: it is the backplane
  };
  struct Change {
    bool is_news = false;
    std::vector<ViewerId> gone = {};
  };

  /// All of whom this one knows now; more than kMaxPeopleElsewhere in all are left out, and so is
  /// who is kMaxHubsAway away.
  Change tell(const Teller& teller, const wire::pb::PeopleHere& people, const NewId& new_id);
  /// It knows of nobody any more.
  Change forget(ConnectionId teller);

  /// The id here of whom this one calls so; nothing: it has not told of such a person.
  [[nodiscard]] std::optional<ViewerId> find(ConnectionId teller, std::uint32_t id_there) const;
  /// Adds them to those who are here, as far as a roster holds them.
  void write_to(wire::pb::Roster& roster) const;

 private:
  using People = std::map<std::uint32_t, wire::pb::ViewerEntry>;  // by ids there

  [[nodiscard]] std::size_t count() const;

  std::unordered_map<ConnectionId, People> told_;
};

}  // namespace roomcast::hub
