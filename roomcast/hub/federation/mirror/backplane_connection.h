// SPDX-License-Identifier: Apache-2.0
// BackplaneConnection: a client of a room here that a backplane represents: a sensor of another
// hub, or the aligner that brings in its poses and people. Threading: the rooms' thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "roomcast/hub/runtime/connection.h"

namespace roomcast::hub::federation {

/// A backplane's part of one room: it gets what the room sends to the backplane's connections.
class BackplaneRoom {
 public:
  virtual ~BackplaneRoom() = default;
  /// A message of the room here to one of our connections.
  virtual void on_room_message(ConnectionId to, const wire::pb::Control& message) = 0;
  /// The room here has removed this connection.
  virtual void on_removed(ConnectionId connection) = 0;
};

class BackplaneConnection final : public hub::Connection {
 public:
  /// Returns null once the room is closed or no longer pulled.
  using FindRoom = std::function<BackplaneRoom*()>;

  BackplaneConnection(ConnectionId id, FindRoom find_room)
      : Connection(id), find_room_(std::move(find_room)) {}

  void accept(hub::Role, RoomId) override {}  // the Welcome follows
  void deliver(hub::ControlFanOut& control) override {
    if (BackplaneRoom* room = find_room_()) room->on_room_message(id(), control.message());
  }
  void disconnect(wire::pb::ErrorCode, const std::string&) override {
    if (BackplaneRoom* room = find_room_()) room->on_removed(id());
  }

 private:
  const FindRoom find_room_;
};

/// Makes a connection with a new ID.
using NewConnection = std::function<hub::ConnectionPtr()>;

}  // namespace roomcast::hub::federation
