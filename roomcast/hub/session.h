// SPDX-License-Identifier: Apache-2.0
// Session: one connection of a hub. Turns bytes into the room's events, and holds what waits to be
// written back. Threading: the hub's event loop.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/outbox.h"
#include "roomcast/net/websocket_connection.h"
#include "roomcast/wire/control.pb.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub {

/// Whom a session tells what has come in. Implemented by the hub.
class SessionEvents {
 public:
  virtual ~SessionEvents() = default;
  virtual void on_join(ConnectionId from, const wire::pb::Join& join) = 0;
  virtual void on_control(ConnectionId from, const wire::pb::Control& message) = 0;
  virtual void on_frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message) = 0;
  virtual void on_key_needs(const std::vector<SensorId>& sensors) = 0;
  /// The session is over; it is not used after this.
  virtual void on_left(ConnectionId from, const net::CloseReason& reason) = 0;
};

class Session final : public net::ConnectionHandler {
 public:
  Session(ConnectionId id, const std::shared_ptr<net::WebSocketConnection>& connection,
          SessionEvents& hub);

  void on_message(net::MessageBuffer message) override;
  net::SealedMessagePtr next_message() override;
  void on_closed(const net::CloseReason& reason) override;

  /// The room has taken it in.
  void accept(bool is_sensor);
  [[nodiscard]] bool has_joined() const { return has_joined_; }

  /// False when the peer lets its control messages pile up: disconnect it.
  [[nodiscard]] bool send_control(net::SealedMessagePtr message);
  void send_set(FrameSetPtr set);
  void restart_sensor(SensorId sensor) { outbox_.forget(sensor); }

  /// Says why and closes. Nothing more comes from it but on_left.
  void disconnect(wire::pb::ErrorCode code, const std::string& sentence);

 private:
  void take(net::MessageBuffer message);
  void take_frame(net::MessageBuffer message);
  void take_control(std::span<const std::uint8_t> message);
  void refuse(const Error& error);
  void wake() const;

  const ConnectionId id_;
  const std::weak_ptr<net::WebSocketConnection> connection_;  // which owns this session
  SessionEvents& hub_;
  Outbox outbox_;
  bool has_joined_ = false;
  bool is_sensor_ = false;
};

}  // namespace roomcast::hub
