// SPDX-License-Identifier: Apache-2.0
// Shard: one thread's share of a hub's connections. What its sessions say goes to the rooms'
// thread; what a room wants done comes back, a frame set once for all its viewers here. Nothing is
// shared with other shards but immutable messages, so nothing is locked.
//
// Threading: sessions live on the thread that runs `io`. The members marked "any thread" may be
// called from elsewhere: they are carried out there, in the order of their calls; called from that
// thread they are carried out at once.
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
#include "roomcast/hub/runtime/session.h"

namespace roomcast::hub {

/// Connections of all shards that have not joined.
using UnjoinedCount = std::atomic<std::size_t>;

struct ShardLimits {
  std::chrono::milliseconds join_within = wire::kJoinDeadline;
  std::size_t max_unjoined = wire::kMaxUnjoinedConnections;  // over all shards
  SessionLimits session = {};
};

/// What was sent, as one shard knows it. Counters grow.
struct ShardTraffic {
  struct Viewer {
    ConnectionId connection;
    std::uint64_t bytes = 0;
    std::uint64_t dropped_sets = 0;
  };
  struct Room {
    RoomId room;
    std::uint64_t dropped_sets = 0;  // over all viewers that were ever here
  };
  std::vector<Viewer> viewers;
  std::vector<Room> rooms;
};

class Shard final : public SessionEvents {
 public:
  struct Place {
    std::size_t index = 0, count = 1;  // which of how many shards
    boost::asio::io_context& io;
    boost::asio::io_context& room_io;  // perhaps the same
  };

  /// `room` is told of everything, on the thread that runs `room_io`.
  Shard(Place place, SessionEvents& room, UnjoinedCount& unjoined, ShardLimits limits = {});

  /// A new connection of this shard; null when too many have not joined.
  std::shared_ptr<net::ConnectionHandler> welcome(
      const std::shared_ptr<net::WebSocketConnection>& connection);

  /// Which of `count` shards has this connection.
  [[nodiscard]] static std::size_t of(ConnectionId connection, std::size_t count) {
    return connection.value % count;
  }

  // Any thread. What is for a connection that has gone is dropped.
  void accept(ConnectionId connection, Role role, RoomId room);
  void send_control(std::vector<ConnectionId> to, net::FramedMessagePtr message);
  void send_set(RoomId room, FrameSetPtr set);
  void restart_sensor(RoomId room, SensorId sensor);
  void disconnect(ConnectionId connection, wire::pb::ErrorCode code, std::string sentence);
  /// Nobody is in it any more.
  void forget(RoomId room);
  /// Tells what its viewers were sent, on the rooms' thread.
  void report_traffic(std::function<void(ShardTraffic)> to);

  // From the sessions.
  void on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) override;
  void on_control(ConnectionId from, const wire::pb::Control& message) override;
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override;
  void on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) override;
  void on_left(ConnectionId from, const net::CloseReason& reason) override;

 private:
  struct Viewers {
    std::vector<Session*> sessions;
    std::uint64_t dropped_sets = 0;  // over all that were ever here
  };

  void expect_join(ConnectionId id);
  [[nodiscard]] Session* find(ConnectionId id) const;

  const Place place_;
  SessionEvents& room_;
  UnjoinedCount& unjoined_;
  const ShardLimits limits_;
  std::uint64_t next_connection_;
  SteadyClock clock_;
  std::unordered_map<ConnectionId, std::shared_ptr<Session>> sessions_;
  std::unordered_map<RoomId, Viewers> viewers_;  // those of sessions_ that get frame sets
};

}  // namespace roomcast::hub
