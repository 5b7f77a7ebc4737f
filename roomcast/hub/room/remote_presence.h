// SPDX-License-Identifier: Apache-2.0
// RemotePresence: the people who watch a room at other hubs. They are reported by viewers that are
// hubs themselves, and by the backplane for peer hubs and upstream hubs. Each person gets a viewer
// ID of this room, so that a connection can only speak for the people that it reported. Pure.
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
  struct Reporter {
    ConnectionId connection;
    ViewerId viewer{};  // its viewer ID in this room; 0: it is the backplane
  };
  struct Change {
    bool has_changed = false;
    std::vector<ViewerId> gone = {};
  };

  /// Replaces the list of people that a connection reports. People beyond kMaxPeopleElsewhere in
  /// all, or already kMaxHubsAway hubs away, are left out.
  Change report(const Reporter& reporter, const wire::pb::PeopleHere& people, const NewId& new_id);
  /// Removes all people that this connection reported.
  Change forget(ConnectionId reporter);

  /// The ID in this room of a person reported under `id_there`; nothing: this connection reported
  /// no such person.
  [[nodiscard]] std::optional<ViewerId> find(ConnectionId reporter, std::uint32_t id_there) const;
  /// Adds the people to `roster` until it has wire::kMaxViewers entries.
  void write_to(wire::pb::Roster& roster) const;

 private:
  using People = std::map<std::uint32_t, wire::pb::ViewerEntry>;  // by the IDs of the reporting hub

  [[nodiscard]] std::size_t count() const;

  std::unordered_map<ConnectionId, People> reported_;
};

}  // namespace roomcast::hub
