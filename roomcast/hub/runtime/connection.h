// SPDX-License-Identifier: Apache-2.0
// Connection: a client of a room, as the rooms' thread sees it: a session of a shard, or a sensor
// or aligner that a backplane represents. Threading: the rooms' thread, unless noted.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class Shard;

/// Assigns the IDs of a hub's connections. Threading: any thread.
class ConnectionIds {
 public:
  [[nodiscard]] ConnectionId next() { return ConnectionId{++last_}; }

 private:
  std::atomic<std::uint64_t> last_ = 0;
};

/// A control message on its way to several connections. It is encoded once, and posted once to each
/// shard that has receivers.
class ControlFanOut {
 public:
  /// `message` must outlive this.
  explicit ControlFanOut(const wire::pb::Control& message) : message_(message) {}

  [[nodiscard]] const wire::pb::Control& message() const { return message_; }
  /// Adds a session of this shard to the receivers.
  void add(Shard& shard, ConnectionId session);
  /// Posts the message to the shards.
  void send();

 private:
  struct Receivers {
    Shard* shard;
    std::vector<ConnectionId> sessions;
  };
  const wire::pb::Control& message_;
  std::vector<Receivers> by_shard_;
};

class Connection {
 public:
  explicit Connection(ConnectionId id) : id_(id) {}
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Threading: any thread.
  [[nodiscard]] ConnectionId id() const { return id_; }

  /// The room has accepted it in this role.
  virtual void accept(Role role, RoomId room) = 0;
  /// Delivers the message, at once or when the fan-out is sent.
  virtual void deliver(ControlFanOut& control) = 0;
  /// The room has removed it, or refused it. No other call follows.
  virtual void disconnect(wire::pb::ErrorCode code, const std::string& sentence) = 0;

  /// Delivers a message to this connection alone, at once.
  void send(const wire::pb::Control& message);

 private:
  const ConnectionId id_;
};

using ConnectionPtr = std::shared_ptr<Connection>;

}  // namespace roomcast::hub
