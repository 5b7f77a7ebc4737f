// SPDX-License-Identifier: Apache-2.0
// SharedRoom: one room of this hub among hubs that have it too. It tells the others what sends to
// this hub and who watches here, brings in what sends to them and who watches there, and sees that
// a name is one sensor everywhere: who came last has it. One of the hubs, the room's owner, works
// out where all sensors stand; it gets what the others' sensors see for that, and its word on poses
// holds everywhere.
//
// In the room here it is an aligner, and a sensor for each of another hub's. Pure but for whom it
// tells. Threading: the rooms' thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/hub/federation/cluster/cluster.pb.h"
#include "roomcast/hub/federation/cluster/frame_parts.h"
#include "roomcast/hub/federation/cluster/hub_id.h"
#include "roomcast/hub/federation/cluster/presence_id_map.h"
#include "roomcast/hub/federation/mirror/mirrored_sensors.h"
#include "roomcast/hub/federation/mirror/presence_relay.h"
#include "roomcast/hub/federation/mirror/shown_presence.h"
#include "roomcast/hub/runtime/backplane.h"

namespace roomcast::hub::federation {

/// What a room says to other hubs.
class SharedRoomOut {
 public:
  virtual ~SharedRoomOut() = default;
  virtual void tell_all(const pb::RoomNews& news) = 0;
  virtual void tell(HubId hub, const pb::ToHub& message) = 0;
  virtual void tell_moved(const std::string& room, const pb::PeopleMoved& people) = 0;
};

class SharedRoom {
 public:
  struct Seat {
    HubId own;
    std::string room;
    std::string token;  // lets anybody into it
    hub::BackplaneEvents& rooms;
    hub::federation::MirroredSensors::NewConnection new_connection;
    SharedRoomOut& out;
  };

  explicit SharedRoom(Seat seat);

  /// Is in the room again if it was sent away. Call it at first, and now and then.
  void stay();

  // From the room here.
  /// To one of our connections.
  void said(ConnectionId to, const wire::pb::Control& message);
  void let_go(ConnectionId connection);
  /// A sensor with a connection here is let in.
  void sensor_joins(const std::string& name, const std::string& token_id);

  // From other hubs.
  void news(const pb::RoomNews& news);
  void take(const pb::ToHub& message);
  void frames(HubId from, std::span<const std::uint8_t> message);
  void people_moved(const pb::PeopleMoved& people);
  void clock_is(HubId hub, const client::ClockEstimate& estimate);
  void hub_is_gone(HubId hub);
  /// Who works out where sensors stand; nothing: nobody.
  void owner_is(std::optional<HubId> owner);

  /// Where those who watch here are, for who has come since or missed it.
  void tell_poses_again();

  /// Where else this room is.
  void others_are(const std::vector<std::string>& urls);

  /// Of the newest news of this hub. 0: nothing ever.
  [[nodiscard]] std::uint32_t revision() const { return news_.revision(); }
  /// Of the newest news of that hub. 0: nothing.
  [[nodiscard]] std::uint32_t revision_of(HubId hub) const;
  [[nodiscard]] std::size_t local_sensor_count() const {
    return static_cast<std::size_t>(news_.sensors_size());
  }
  /// Does anything in the room here come from another hub?
  [[nodiscard]] bool has_sensors_elsewhere() const {
    return std::ranges::any_of(
        others_, [](const auto& other) { return !other.second.sensors.all().empty(); });
  }
  /// At this hub.
  [[nodiscard]] std::size_t viewer_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        roster_.viewers(), [](const auto& viewer) { return viewer.hubs_away() == 0; }));
  }
  [[nodiscard]] const std::string& name() const { return seat_.room; }

 private:
  /// Whose a sensor's name is: the highest has it.
  struct Claim {
    std::uint32_t number = 0;
    HubId hub;
    friend auto operator<=>(const Claim&, const Claim&) = default;
  };
  struct OwnClaim {
    std::uint32_t number = 0;
    std::string token_id;
  };
  struct OtherHub {
    pb::RoomNews news;
    hub::federation::MirroredSensors sensors;
    FrameUnpacker unpacker;
  };

  void join();
  void leave();
  [[nodiscard]] OtherHub& other(HubId hub);
  void take_roster(const wire::pb::Roster& roster);
  void tell_news();
  [[nodiscard]] pb::RoomNews news_of_roster() const;
  void follow_winners();
  [[nodiscard]] Claim winner(const std::string& sensor) const;
  [[nodiscard]] bool is_mirrored(const std::string& sensor) const;
  [[nodiscard]] bool is_local(std::uint32_t sensor_id) const;
  void forget_claims();

  void show_people();
  void tell_moved(const wire::pb::ViewerPoses& poses);

  void place_sensors();
  void pass_to_owner(const wire::pb::Control& said_here);
  void ask_for_bundles(HubId hub);
  void take_said(HubId from, const pb::SensorSaid& said);
  void take_nudge(const pb::NudgeByName& nudge);
  [[nodiscard]] bool is_owner() const { return owner_ == seat_.own; }
  [[nodiscard]] pb::ToHub message_to_hub() const;
  [[nodiscard]] const wire::pb::SensorEntry* entry_of(const std::string& sensor) const;

  const Seat seat_;
  std::optional<ConnectionId> aligner_;
  bool is_welcome_ = false;
  wire::pb::Roster roster_;  // of the room here, newest
  pb::RoomNews news_;        // as last told
  std::map<std::string, OwnClaim> claims_;
  std::map<HubId, OtherHub> others_;
  hub::federation::PresenceRelay people_here_;
  PresenceIdMap people_there_;
  hub::federation::ShownPresence shown_presence_;  // of these, in the room here
  std::optional<HubId> owner_;
  std::vector<std::string> other_urls_;
};

}  // namespace roomcast::hub::federation
