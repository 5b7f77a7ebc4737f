// SPDX-License-Identifier: Apache-2.0
// ClusterHub: the backplane of a hub that shares its rooms with other hubs over NATS. Several times
// a second every hub sends a heartbeat with the state of its rooms and the rooms of which it wants
// frames. A hub receives a room's frames only while it has viewers in the room, and for a short
// time afterwards. Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "roomcast/hub/federation/cluster/frame_parts.h"
#include "roomcast/hub/federation/cluster/hub_directory.h"
#include "roomcast/hub/federation/cluster/processor_load.h"
#include "roomcast/hub/federation/cluster/shared_room.h"
#include "roomcast/hub/federation/nats/nats_client.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub::federation {

struct ClusterOptions {
  NatsOptions nats;
  std::string public_url;  // how clients reach this hub; empty: not advertised
  /// Set if this hub can estimate sensor poses: called when it starts or stops doing so for a room.
  std::function<void(const std::string& room, bool owns)> on_owned = {};
  float cores = 1;  // processor cores available to this hub
  /// Share of these cores, from 0 to 1: a hub that uses more redirects new viewers to a much less
  /// busy hub. 0: never.
  float busy_share = 0.75F;
  /// How long a room's frames are still received after its last viewer has left.
  std::chrono::milliseconds kept_unwatched{3000};
  LogSink log = {};
};

class ClusterHub final : public hub::Backplane, private SharedRoomOut {
 public:
  /// Frames that complete a set are sent in one message. If the room also has sensors at other
  /// hubs, completing the set would wait for their frames; then the frames that arrive within this
  /// time are sent together.
  static constexpr std::chrono::milliseconds kGatherFor{8};
  /// Every so many heartbeats, all rooms are listed and the poses of people at rest are sent again.
  static constexpr unsigned kHeartbeatsPerList = 8;

  /// Errors of NatsClient::open.
  static Result<std::unique_ptr<ClusterHub>> open(ClusterOptions options,
                                                  hub::BackplaneContext context);
  ~ClusterHub() override;

  void room_opened(const std::string& room) override;
  void room_closed(const std::string& room) override;
  void watch(const std::string& room, bool is_watched) override;
  void sensor_joins(const std::string& room, const std::string& name,
                    const std::string& token_id) override;
  void frame(const std::string& room, const wire::FrameHeader& header,
             std::span<const std::uint8_t> message) override;
  void set_closed(const std::string& room) override;
  void revoked(const std::vector<hub::Claims>& tokens) override;
  [[nodiscard]] std::vector<hub::HubStatus> hubs() const override;
  [[nodiscard]] hub::BackplaneStats stats() const override;
  [[nodiscard]] std::vector<std::string> less_busy_hubs(const std::string& room) const override;

 private:
  struct Room {
    std::unique_ptr<SharedRoom> shared;
    FramePacker packer;
    net::Timer gathered, unwatched;
    std::size_t viewers = 0;
    bool is_watched = false, is_subscribed = false;
    bool is_wanted = false;  // by another hub
    std::optional<HubId> owner = {};
    std::set<HubId> asked = {};  // asked for their news since our last heartbeat
  };
  using Rooms = std::map<std::string, std::unique_ptr<Room>, std::less<>>;  // by name

  ClusterHub(ClusterOptions options, hub::BackplaneContext context);

  void broadcast_news(const pb::RoomNews& news) override;
  void send_to(HubId hub, const pb::ToHub& message) override;
  void broadcast_poses(const std::string& room, const pb::PeopleMoved& people) override;

  void on_message(std::string_view subject, std::span<const std::uint8_t> message);
  void on_revoked(const pb::Revoked& revoked);
  void on_heartbeat(const pb::Heartbeat& heartbeat);
  void schedule_heartbeat();
  void run_heartbeat();
  void send_heartbeat(bool leaves = false);
  [[nodiscard]] pb::Heartbeat heartbeat() const;
  void update_rooms();
  void report_owned(const std::string& room, bool owns) const;
  void flush(Room& room);
  void update_wanted(const std::string& name, Room& room);
  [[nodiscard]] Room* find(std::string_view room);

  const ClusterOptions options_;
  const hub::BackplaneContext context_;
  const HubId id_ = new_hub_id();
  SteadyClock clock_;
  HubDirectory directory_{id_};
  ProcessorLoad load_;
  std::vector<std::string> reported_urls_;  // as last passed to set_peer_urls()
  std::unique_ptr<NatsClient> nats_;
  unsigned heartbeat_number_ = 0;
  Rooms rooms_;
  net::Timer timer_;
  std::minstd_rand random_{std::random_device{}()};
};

}  // namespace roomcast::hub::federation
