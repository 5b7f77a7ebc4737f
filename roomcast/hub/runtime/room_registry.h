// SPDX-License-Identifier: Apache-2.0
// RoomRegistry: all rooms of a hub. It admits clients, passes their events to their room, and
// disconnects them when their token expires or is revoked. Threading: the rooms' thread, on which
// shards report the events of their sessions and the store worker its answers.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/access/ban_list.h"
#include "roomcast/hub/access/entry.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/runtime/embed_sites.h"
#include "roomcast/hub/runtime/room_events.h"
#include "roomcast/hub/runtime/room_runner.h"
#include "roomcast/hub/runtime/sensor_requests.h"
#include "roomcast/hub/runtime/session.h"
#include "roomcast/hub/runtime/shard.h"
#include "roomcast/hub/runtime/traffic_meter.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub {

struct RoomRegistryOptions {
  std::string hub_version;
  bool restores_poses = true;  // restore poses estimated before the hub was started
  std::set<std::string> configured_rooms = {};  // opened at every start of the hub
  BanRules bans = {};
  std::vector<std::string> never_banned = {};  // proxies, which share one address for many clients
  std::function<void(const std::string& room)> on_in_use = {};  // a room's first sensor has joined
  LogSink log = {};
};

class RoomRegistry final : public BackplaneEvents {
 public:
  RoomRegistry(RoomRegistryOptions options, boost::asio::io_context& io, StoreWorker& store_worker,
               const std::vector<std::unique_ptr<Shard>>& shards);

  /// Sets the backplane to other hubs. Must be called before any room is opened.
  void connect(Backplane& backplane) { backplane_ = &backplane; }
  /// Starts the timer for expired tokens and traffic rates.
  void start();

  // Rooms. Closing a room disconnects its clients.
  void open(const RoomSettings& settings, KnownRoom known);
  void change(const RoomSettings& settings);
  void close(const std::string& room);
  [[nodiscard]] bool is_configured(const std::string& room) const {
    return options_.configured_rooms.contains(room);
  }
  [[nodiscard]] const RoomSettings* find(const std::string& room) const;
  [[nodiscard]] std::size_t room_count() const { return rooms_.size(); }

  /// In the order of the names.
  [[nodiscard]] std::vector<RoomStats> stats() const;
  [[nodiscard]] std::optional<RoomStats> stats(const std::string& room) const;
  [[nodiscard]] std::uint64_t refused_joins() const { return refused_joins_; }
  [[nodiscard]] std::size_t banned_count() const { return bans_.banned_count(clock_.now()); }
  /// "192.0.2.7:50312"; empty: the client has disconnected.
  [[nodiscard]] std::string address_of(ConnectionId client) const;

  /// Notes what happened in a room, for those who run it. No effect: there is no such room.
  void note(const std::string& room, RoomEvent event);
  [[nodiscard]] RoomEvents::Page events(const std::string& room, std::uint64_t after) const;
  /// Asks a sensor of an open room for other settings, and passes on its answer. Also kNotFound: it
  /// is not online here; kInvalidArgument: it takes no settings.
  void ask_sensor(const std::string& room, const std::string& sensor,
                  wire::pb::SettingsRequest request, SensorRequests::Answered answered);

  /// Makes a room forget a sensor that is offline. The caller removes it from the store.
  void forget_sensor(const std::string& room, const std::string& sensor);
  /// Mutes a viewer of an open room for all, or ends that.
  void mute(const std::string& room, ViewerId viewer, bool muted);
  /// Disconnects a client. False: it is in no room any more.
  bool disconnect_client(ConnectionId client, const std::string& sentence);
  /// Disconnects the clients that joined with one of these tokens.
  void disconnect_token_holders(const std::vector<std::string>& token_ids);
  /// Sends the revoked tokens, if there are any, to the backplane and to hubs that relay rooms of
  /// this hub.
  void send_revoked();
  /// Takes the tokens that other hubs report as revoked.
  void add_revoked(std::vector<Claims> tokens);
  /// Empty: this hub is the only one.
  [[nodiscard]] std::vector<HubStatus> hubs() const {
    return backplane_ == nullptr ? std::vector<HubStatus>() : backplane_->hubs();
  }

  /// Counts a refused token, of a join or of an HTTP request, against this address. An address with
  /// too many bad tokens is banned for a while (BanRules).
  void count_fault(const std::string& peer, const Refusal& why);
  /// Nothing: there is no backplane.
  [[nodiscard]] std::optional<BackplaneStats> backplane_stats() const {
    return backplane_ == nullptr ? std::nullopt : std::optional(backplane_->stats());
  }

  /// The web sites whose pages may show this room. Any thread.
  [[nodiscard]] std::vector<std::string> embedding_sites(const std::string& room) const {
    return embed_sites_.of(room);
  }
  /// Whether the address is not banned. Any thread.
  [[nodiscard]] bool may_connect(const std::string& peer) const;

  void on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) override;
  void on_control(ConnectionId from, const wire::pb::Control& message) override;
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override;
  void on_audio(ConnectionId from, const wire::AudioHeader& header,
                net::MessageBuffer message) override;
  void on_frames(std::span<IncomingFrame> together) override;
  void on_watched_elsewhere(const std::string& room, bool is_watched) override;
  void on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) override;
  void on_small_needs(ConnectionId from, const SmallNeeds& needs) override;
  void on_left(ConnectionId from, const net::CloseReason& reason) override;

 private:
  struct Client {
    std::string address, name = {};
    std::string_view role = {};
    RoomRunner* room = nullptr;
    std::string token_id = {};
    UnixSeconds expires_at = 0;  // 0: never
    bool relays = false;         // it is a hub that relays the room
  };
  struct Sent {
    std::uint64_t bytes = 0, dropped_sets = 0, dropped_audio = 0;
  };
  void on_checked(const ConnectionInfo& connection_info, const wire::pb::Join& join,
                  const Verdict<NewToken>& shown, bool was_code);
  void decide(const ConnectionInfo& connection_info, const wire::pb::Join& join,
              const Claims* claims, const std::string& new_token);
  void refuse(const ConnectionInfo& connection_info, const wire::pb::Join& join, const Refusal& why,
              const std::string& token_id = "");
  void on_removed(const Disconnect& end);
  bool redirect(const ConnectionInfo& connection_info, const wire::pb::Join& join,
                const std::string& room);
  void admit(const ConnectionInfo& connection_info, const wire::pb::Join& join, const Entry& entry);
  [[nodiscard]] RoomRunner* room_of(ConnectionId from) const;
  [[nodiscard]] std::string only_listed_room() const;
  [[nodiscard]] RoomStats stats_of(const RoomRunner& room) const;

  void note_client(const Client& client, const char* kind, const std::string& sentence);
  void note_message(ConnectionId from, const wire::pb::Control& message);
  void note_places(const std::string& room, const std::vector<KnownSensor>& sensors);

  void send_revoked_to_new_hub(ConnectionId hub);
  void send_revoked_to_downstream(const std::vector<Claims>& revoked);
  void send_revoked_to_hub(ConnectionId hub, const std::vector<Claims>& revoked);

  void run_periodic_tasks();
  void disconnect_expired();
  void measure_sensors();
  void record_traffic(std::size_t shard, const ShardTraffic& traffic);
  void log(LogLevel level, const std::string& line,
           std::initializer_list<LogField> fields = {}) const {
    if (options_.log) options_.log(level, line, fields);
  }
  /// `event` and `error` as in docs/guides/hub.md.
  void log_client(const std::string& line, const Client& client, std::string_view event,
                  std::string_view error = {}) const;

  const RoomRegistryOptions options_;
  boost::asio::io_context& io_;
  StoreWorker& store_worker_;
  const std::vector<std::unique_ptr<Shard>>& shards_;
  Backplane* backplane_ = nullptr;
  SteadyClock clock_;
  std::map<std::string, std::shared_ptr<RoomRunner>> rooms_;
  std::uint32_t next_room_id_ = 1;
  std::unordered_map<ConnectionId, Client> clients_;  // clients that asked to join or are in a room
  std::set<RoomId> in_use_;                           // rooms that have had a sensor
  BanList bans_;
  EmbedSites embed_sites_;
  std::map<std::string, RoomEvents> events_;  // by the room's name
  std::map<std::string, std::set<std::string>>
      placed_;  // sensors, as last noted, by the room's name
  SensorRequests requests_;
  std::uint64_t refused_joins_ = 0;
  net::Timer timer_;
  std::unordered_map<ConnectionId, Sent> sent_;
  std::map<std::pair<RoomId, std::size_t>, std::uint64_t> dropped_sets_;  // of a room, by shard
  TrafficMeter<ConnectionId> viewer_bytes_, sensor_bytes_, sensor_frames_;
};

}  // namespace roomcast::hub
