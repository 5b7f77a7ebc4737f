// SPDX-License-Identifier: Apache-2.0
// SharedRoom: one room of this hub that other hubs have as well. It reports this hub's sensors and
// people to the others, mirrors theirs in the room here, and ensures that a name denotes one sensor
// on all hubs: the last to join gets it. One of the hubs, the room's owner, estimates the poses of
// all sensors; the others forward their sensors' bundles and sightings to it, and its poses are
// valid on all hubs.
//
// In the room here it is an aligner, and one sensor for each mirrored sensor. Pure except for its
// calls to `rooms` and `out`. Threading: the rooms' thread.
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

/// Messages from a room to other hubs.
class SharedRoomOut {
 public:
  virtual ~SharedRoomOut() = default;
  virtual void broadcast_news(const pb::RoomNews& news) = 0;
  virtual void send_to(HubId hub, const pb::ToHub& message) = 0;
  virtual void broadcast_poses(const std::string& room, const pb::PeopleMoved& people) = 0;
};

class SharedRoom final : public BackplaneRoom {
 public:
  struct Context {
    HubId own;
    std::string room;
    std::string token;  // admits any client to the room
    hub::BackplaneEvents& rooms;
    NewConnection new_connection;
    SharedRoomOut& out;
  };

  explicit SharedRoom(Context context);

  /// Rejoins the room if it was removed. Call it at first, and then periodically.
  void ensure_joined();

  // From the room here.
  void on_room_message(ConnectionId to, const wire::pb::Control& message) override;
  void on_removed(ConnectionId connection) override;
  /// Call when a sensor connected to this hub is admitted.
  void sensor_joins(const std::string& name, const std::string& token_id);

  // From other hubs.
  void on_news(const pb::RoomNews& news);
  void on_message(const pb::ToHub& message);
  void on_frames(HubId from, std::span<const std::uint8_t> message);
  void on_poses(const pb::PeopleMoved& people);
  void set_clock(HubId hub, const client::ClockEstimate& estimate);
  void remove_hub(HubId hub);
  /// Sets the hub that estimates sensor poses; nothing: none.
  void set_owner(std::optional<HubId> owner);

  /// Sends the poses of this hub's people again, for hubs that have joined since or missed them.
  void resend_poses();

  /// Sets the addresses of the other hubs that have this room.
  void set_other_urls(const std::vector<std::string>& urls);

  /// Of the newest news of this hub. 0: none so far.
  [[nodiscard]] std::uint32_t revision() const { return news_.revision(); }
  /// Of the newest news of that hub. 0: none.
  [[nodiscard]] std::uint32_t revision_of(HubId hub) const;
  [[nodiscard]] std::size_t local_sensor_count() const {
    return static_cast<std::size_t>(news_.sensors_size());
  }
  /// Whether the room here has sensors from another hub.
  [[nodiscard]] bool has_sensors_elsewhere() const {
    return std::ranges::any_of(
        others_, [](const auto& other) { return !other.second.sensors.all().empty(); });
  }
  /// At this hub.
  [[nodiscard]] std::size_t viewer_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        roster_.viewers(), [](const auto& viewer) { return viewer.hubs_away() == 0; }));
  }
  [[nodiscard]] const std::string& name() const { return context_.room; }

 private:
  /// A claim to a sensor's name: the highest one wins.
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
  void publish_news();
  [[nodiscard]] pb::RoomNews news_of_roster() const;
  void mirror_winners();
  [[nodiscard]] Claim winner(const std::string& sensor) const;
  [[nodiscard]] bool is_mirrored(const std::string& sensor) const;
  [[nodiscard]] bool is_local(std::uint32_t sensor_id) const;
  void forget_claims();

  void show_people();
  void broadcast_poses(const wire::pb::ViewerPoses& poses);

  void place_sensors();
  void forward_to_owner(const wire::pb::Control& local);
  void request_bundles(HubId hub);
  void on_sensor_message(HubId from, const pb::SensorMessage& message);
  void on_nudge(const pb::NamedNudge& nudge);
  [[nodiscard]] bool is_owner() const { return owner_ == context_.own; }
  [[nodiscard]] pb::ToHub message_to_hub() const;
  [[nodiscard]] const wire::pb::SensorEntry* entry_of(const std::string& sensor) const;

  const Context context_;
  std::optional<ConnectionId> aligner_;
  bool is_welcome_ = false;
  wire::pb::Roster roster_;  // of the room here, newest
  pb::RoomNews news_;        // as last sent
  std::map<std::string, OwnClaim> claims_;
  std::map<HubId, OtherHub> others_;
  hub::federation::PresenceRelay people_here_;
  PresenceIdMap people_there_;
  hub::federation::ShownPresence shown_presence_;  // people_there_ as last shown in the room here
  std::optional<HubId> owner_;
  std::vector<std::string> other_urls_;
};

}  // namespace roomcast::hub::federation
