// SPDX-License-Identifier: Apache-2.0
// Shard: one thread's share of a hub's connections. Events of its sessions go to the rooms' thread.
// Actions of a room come back; a frame set comes once for all its viewers here. Shards share only
// immutable messages and an atomic counter, so there are no locks.
//
// Threading: sessions live on the thread that runs `io`. The members marked "any thread" may be
// called from other threads: they are posted to that thread and run there in the order of the
// calls. When called from that thread they run at once.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/hub/runtime/connection.h"
#include "roomcast/hub/runtime/session.h"

namespace roomcast::hub {

/// The number of connections, over all shards, that have not joined.
using UnjoinedCount = std::atomic<std::size_t>;

struct ShardLimits {
  std::chrono::milliseconds join_within = wire::kJoinDeadline;
  std::size_t max_unjoined = wire::kMaxUnjoinedConnections;  // over all shards
  SessionLimits session = {};
};

/// Bytes sent, sets and audio dropped by one shard. The counters only grow.
struct ShardTraffic {
  struct Viewer {
    ConnectionId connection;
    std::uint64_t bytes = 0;
    std::uint64_t dropped_sets = 0;
    std::uint64_t dropped_audio = 0;  // packets
  };
  struct Room {
    RoomId room;
    std::uint64_t dropped_sets = 0;  // over all viewers so far
  };
  std::vector<Viewer> viewers;
  std::vector<Room> rooms;
};

class Shard final : public SessionEvents {
 public:
  struct Loops {
    boost::asio::io_context& io;
    boost::asio::io_context& room_io;  // may be the same as `io`
  };

  /// `room` gets all events, on the thread that runs `room_io`. All shards share `ids` and
  /// `unjoined`.
  Shard(Loops loops, SessionEvents& room, ConnectionIds& ids, UnjoinedCount& unjoined,
        ShardLimits limits = {});

  /// Adds a new connection; null: too many connections have not joined.
  std::shared_ptr<net::ConnectionHandler> add_session(
      const std::shared_ptr<net::WebSocketConnection>& connection);

  // Any thread. Calls for a connection that has closed have no effect.
  void accept(ConnectionId connection, Role role, RoomId room);
  void send_control(std::vector<ConnectionId> to, net::FramedMessagePtr message);
  void send_set(RoomId room, FrameSetPtr set);
  void send_audio(std::vector<ConnectionId> to, ViewerId speaker, net::FramedMessagePtr packet);
  void set_details(ConnectionId viewer, SensorDetails details);
  void restart_sensor(RoomId room, SensorId sensor);
  void disconnect(ConnectionId connection, wire::pb::ErrorCode code, std::string sentence);
  /// The room has no clients any more.
  void forget(RoomId room);
  /// Reports the traffic of this shard's viewers, on the rooms' thread.
  void report_traffic(std::function<void(ShardTraffic)> to);

  // Events of the sessions.
  void on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) override;
  void on_control(ConnectionId from, const wire::pb::Control& message) override;
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override;
  void on_audio(ConnectionId from, const wire::AudioHeader& header,
                net::MessageBuffer message) override;
  void on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) override;
  void on_small_needs(ConnectionId from, const SmallNeeds& needs) override;
  void on_left(ConnectionId from, const net::CloseReason& reason) override;

 private:
  struct Viewers {
    std::vector<Session*> sessions;
    std::uint64_t dropped_sets = 0;  // over all viewers so far
  };

  void start_join_deadline(ConnectionId id);
  [[nodiscard]] Session* find(ConnectionId id) const;

  const Loops loops_;
  SessionEvents& room_;
  ConnectionIds& ids_;
  UnjoinedCount& unjoined_;
  const ShardLimits limits_;
  SteadyClock clock_;
  std::unordered_map<ConnectionId, std::shared_ptr<Session>> sessions_;
  std::unordered_map<RoomId, Viewers> viewers_;  // the sessions_ that get frame sets
};

}  // namespace roomcast::hub
