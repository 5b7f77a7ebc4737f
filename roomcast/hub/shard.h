// SPDX-License-Identifier: Apache-2.0
// Shard: one thread's share of a hub's connections. What its sessions say goes to the room's
// thread; what the room wants done comes back, a frame set once for all viewers here. Nothing is
// shared with other shards but immutable messages, so nothing is locked.
//
// Threading: sessions live on the thread that runs `io`. The members marked "any thread" may be
// called from elsewhere: they are carried out there, in the order of their calls; called from that
// thread they are carried out at once.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/room_action.h"
#include "roomcast/hub/session.h"

namespace roomcast::hub {

/// Connections of all shards that have not joined.
using UnjoinedCount = std::atomic<std::size_t>;

class Shard final : public SessionEvents {
 public:
  struct Place {
    std::size_t index = 0, count = 1;  // which of how many shards
    boost::asio::io_context& io;
    boost::asio::io_context& room_io;  // perhaps the same
  };

  /// `room` is told of everything, on the thread that runs `room_io`.
  Shard(Place place, SessionEvents& room, UnjoinedCount& unjoined,
        std::chrono::milliseconds join_within);

  /// A new connection of this shard; null when too many have not joined.
  std::shared_ptr<net::ConnectionHandler> welcome(
      const std::shared_ptr<net::WebSocketConnection>& connection);

  /// Which of `count` shards has this connection.
  [[nodiscard]] static std::size_t of(ConnectionId connection, std::size_t count) {
    return connection.value % count;
  }

  // Any thread. What is for a connection that has gone is dropped.
  void accept(ConnectionId connection, Role role);
  void send_control(std::vector<ConnectionId> to, net::SealedMessagePtr message);
  void send_set(FrameSetPtr set);
  void restart_sensor(SensorId sensor);
  void disconnect(ConnectionId connection, wire::pb::ErrorCode code, std::string sentence);
  /// Left out for slow viewers, over all that were ever here.
  [[nodiscard]] std::uint64_t dropped_sets() const { return dropped_sets_; }

  // From the sessions.
  void on_join(ConnectionId from, const wire::pb::Join& join) override;
  void on_control(ConnectionId from, const wire::pb::Control& message) override;
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override;
  void on_key_needs(const std::vector<SensorId>& sensors) override;
  void on_left(ConnectionId from, const net::CloseReason& reason) override;

 private:
  void expect_join(ConnectionId id);
  [[nodiscard]] Session* find(ConnectionId id) const;

  const Place place_;
  SessionEvents& room_;
  UnjoinedCount& unjoined_;
  const std::chrono::milliseconds join_within_;
  std::uint64_t next_connection_;
  std::atomic<std::uint64_t> dropped_sets_ = 0;
  SteadyClock clock_;
  std::unordered_map<ConnectionId, std::shared_ptr<Session>> sessions_;
  std::vector<Session*> viewers_;  // those of sessions_ that get frame sets
};

}  // namespace roomcast::hub
