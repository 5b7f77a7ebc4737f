// SPDX-License-Identifier: Apache-2.0
// HubDirectory: the other live hubs, from their heartbeats, and the offsets of their clocks to
// ours. Pure: time is an argument.
//
// Heartbeats also synchronise the clocks: one of ours left at t1 and arrived there at t2; their
// next one left at t3 and arrived here at t4. After subtracting the time t3 - t2 this is one
// exchange of NTP (RFC 5905 section 8), without additional messages; client/clock_sync.h filters.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/client/clock_sync.h"
#include "roomcast/core/clock.h"
#include "roomcast/hub/federation/cluster/cluster.pb.h"
#include "roomcast/hub/federation/cluster/hub_id.h"

namespace roomcast::hub::federation {

/// Mean heartbeat interval, and the silence after which a hub counts as gone.
inline constexpr std::chrono::milliseconds kHeartbeatInterval{150};
inline constexpr std::chrono::milliseconds kGoneAfter{700};
inline constexpr std::size_t kMaxHubs = 256;

struct OtherHub {
  pb::Heartbeat newest;
  HostTime received{};
  client::ClockSync clock = {};
  std::set<std::string> rooms = {};  // all rooms of this hub
};

class HubDirectory {
 public:
  explicit HubDirectory(HubId own) : own_(own) {}

  /// False, and ignored: the heartbeat is our own or invalid, it is a farewell of an unknown hub,
  /// or there are too many hubs.
  bool update(const pb::Heartbeat& heartbeat, HostTime now);
  /// Removes and returns the hubs that are shutting down or silent for too long.
  [[nodiscard]] std::vector<HubId> remove_gone(HostTime now);
  /// Adds the other hubs' newest heartbeats to `own`.
  void write_heard(pb::Heartbeat& own) const;

  [[nodiscard]] const std::map<HubId, OtherHub>& others() const { return others_; }
  /// Null: there is no such hub.
  [[nodiscard]] const OtherHub* find(HubId hub) const;
  /// Other hubs that have this room: public addresses, sorted, at most wire::kMaxOtherHubs.
  [[nodiscard]] std::vector<std::string> urls_with(const std::string& room) const;
  /// Those of them whose busy share is at most half of this hub's, the least busy first.
  [[nodiscard]] std::vector<std::string> less_busy_with(const std::string& room,
                                                        const pb::Heartbeat& own) const;
  /// Public addresses of all, sorted, at most wire::kMaxOtherHubs.
  [[nodiscard]] std::vector<std::string> urls() const;
  /// Whether any of them wants frames of this room.
  [[nodiscard]] bool is_wanted(std::string_view room) const;

 private:
  [[nodiscard]] std::vector<std::string> urls_of(
      const std::function<bool(const OtherHub&)>& matches) const;
  void update_clock(OtherHub& hub, const pb::Heartbeat& heartbeat, HostTime now) const;

  const HubId own_;
  std::map<HubId, OtherHub> others_;
};

/// The share of its processor cores that a hub uses, 0 to 1; nothing: unknown.
[[nodiscard]] std::optional<float> busy_share(const pb::Heartbeat& hub);

/// Null: the heartbeat does not list this room.
[[nodiscard]] const pb::RoomHere* room_of(const pb::Heartbeat& heartbeat, std::string_view room);

/// The hub that estimates the poses of a room's sensors: of the hubs able to, one that has sensors
/// is preferred to one without, then the lowest ID. All hubs that received the same heartbeats
/// agree. Nothing: no hub is able to, or the room never had a participant.
[[nodiscard]] std::optional<HubId> owner_of(std::string_view room, const pb::Heartbeat& own,
                                            const HubDirectory& directory);

}  // namespace roomcast::hub::federation
