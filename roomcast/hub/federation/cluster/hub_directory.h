// SPDX-License-Identifier: Apache-2.0
// HubDirectory: the other hubs that are alive, as their heartbeats say, and where their clocks
// stand against ours. Pure: time comes in as an argument.
//
// Heartbeats carry the clock, too: one of ours that left at t1 came there at t2, the next one of
// theirs left at t3 and came here at t4. Less the time that it lay there this is one exchange of
// NTP (RFC 5905 section 8), for which no message of its own is sent; client/clock_sync.h filters.
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

/// How often a hub says that it is alive, and after which silence it is not.
inline constexpr std::chrono::milliseconds kHeartbeatInterval{150};
inline constexpr std::chrono::milliseconds kGoneAfter{700};
inline constexpr std::size_t kMaxHubs = 256;

struct OtherHub {
  pb::Heartbeat newest;
  HostTime received{};
  client::ClockSync clock = {};
  std::set<std::string> rooms = {};  // all that it has
};

class HubDirectory {
 public:
  explicit HubDirectory(HubId own) : own_(own) {}

  /// False: it is our own, says nonsense, or there are too many.
  bool take(const pb::Heartbeat& heartbeat, HostTime now);
  /// Those that say that they go, and those that have said nothing for too long. Each once.
  [[nodiscard]] std::vector<HubId> take_gone(HostTime now);
  /// What the others need to know of their last heartbeat.
  void write_heard(pb::Heartbeat& own) const;

  [[nodiscard]] const std::map<HubId, OtherHub>& others() const { return others_; }
  /// Null: there is no such hub.
  [[nodiscard]] const OtherHub* find(HubId hub) const;
  /// Where else this room is: public addresses, sorted, at most wire::kMaxOtherHubs.
  [[nodiscard]] std::vector<std::string> urls_with(const std::string& room) const;
  /// Those of them that use at most half as much of their processor as this one does, the least
  /// busy first.
  [[nodiscard]] std::vector<std::string> less_busy_with(const std::string& room,
                                                        const pb::Heartbeat& own) const;
  /// Public addresses of all, sorted, at most wire::kMaxOtherHubs.
  [[nodiscard]] std::vector<std::string> urls() const;
  /// Does any of them want frames of this room?
  [[nodiscard]] bool is_wanted(std::string_view room) const;

 private:
  [[nodiscard]] std::vector<std::string> urls_of(
      const std::function<bool(const OtherHub&)>& is_meant) const;
  void learn_clock(OtherHub& hub, const pb::Heartbeat& heartbeat, HostTime now) const;

  const HubId own_;
  std::map<HubId, OtherHub> others_;
};

/// How much of its processor a hub uses, from 0 to 1; nothing: it does not say.
[[nodiscard]] std::optional<float> busy_share(const pb::Heartbeat& hub);

/// Null: it says nothing of this room.
[[nodiscard]] const pb::RoomHere* room_of(const pb::Heartbeat& heartbeat, std::string_view room);

/// Which hub works out where a room's sensors stand: of those that could, one that has sensors
/// before one that has none, then the lowest id. All who hear the same heartbeats say the same.
/// Nothing: none could, or there never was a sensor.
[[nodiscard]] std::optional<HubId> owner_of(std::string_view room, const pb::Heartbeat& own,
                                            const HubDirectory& directory);

}  // namespace roomcast::hub::federation
