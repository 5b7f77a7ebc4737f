// SPDX-License-Identifier: Apache-2.0
// Connection: a client of a room, as the rooms' thread sees it: a session of a shard, or a sensor
// or aligner that a backplane represents. Threading: the rooms' thread, unless noted.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
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

/// The receivers of a message, sorted by the shards that have them.
class ReceiversByShard {
 public:
  struct Receivers {
    Shard* shard;
    std::vector<ConnectionId> sessions;
  };

  void add(Shard& shard, ConnectionId session);
  [[nodiscard]] bool empty() const { return by_shard_.empty(); }
  /// Leaves none.
  [[nodiscard]] std::vector<Receivers> take() { return std::exchange(by_shard_, {}); }

 private:
  std::vector<Receivers> by_shard_;
};

/// A control message on its way to several connections. It is encoded once, and posted once to each
/// shard that has receivers.
class ControlFanOut {
 public:
  /// `message` must outlive this.
  explicit ControlFanOut(const wire::pb::Control& message) : message_(message) {}

  [[nodiscard]] const wire::pb::Control& message() const { return message_; }
  /// Adds a session of this shard to the receivers.
  void add(Shard& shard, ConnectionId session) { receivers_.add(shard, session); }
  /// Posts the message to the shards.
  void send();

 private:
  const wire::pb::Control& message_;
  ReceiversByShard receivers_;
};

/// An audio packet on its way to several connections. It is posted once to each shard that has
/// receivers.
class AudioFanOut {
 public:
  AudioFanOut(ViewerId speaker, net::FramedMessagePtr packet)
      : speaker_(speaker), packet_(std::move(packet)) {}

  /// Adds a session of this shard to the receivers.
  void add(Shard& shard, ConnectionId session) { receivers_.add(shard, session); }
  /// Posts the packet to the shards.
  void send();

 private:
  const ViewerId speaker_;
  const net::FramedMessagePtr packet_;
  ReceiversByShard receivers_;
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
  /// Delivers the packet when the fan-out is sent. Only sessions get audio.
  virtual void hear(AudioFanOut& /*audio*/) {}
  /// The frames that it gets from now on. Only viewers' sessions get frames.
  virtual void set_details(const SensorDetails& /*details*/) {}
  /// The room has removed it, or refused it. No other call follows.
  virtual void disconnect(wire::pb::ErrorCode code, const std::string& sentence) = 0;

  /// Delivers a message to this connection alone, at once.
  void send(const wire::pb::Control& message);

 private:
  const ConnectionId id_;
};

using ConnectionPtr = std::shared_ptr<Connection>;

}  // namespace roomcast::hub
