// SPDX-License-Identifier: Apache-2.0
// Session: one connection of a hub. Turns bytes into the room's events, holds what waits to be
// written back, and tells the time. Threading: its shard's event loop.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/access/rate_limit.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/hub/runtime/send_queue.h"
#include "roomcast/net/websocket_connection.h"
#include "roomcast/wire/control.pb.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// Who knocks.
struct ConnectionInfo {
  ConnectionId from;
  std::string address;  // "192.0.2.7:50312"
  std::string peer;     // for counting and banning
  /// Of the token that a sensor showed another hub, for which a backplane speaks here.
  std::optional<std::string> token_id_there = {};
  std::uint64_t other_hub = 0;  // at which that sensor is; 0: it is here
};

/// What comes in from sessions: told to their shard, and by it to the room.
class SessionEvents {
 public:
  virtual ~SessionEvents() = default;
  /// Once for each session, before everything else.
  virtual void on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) = 0;
  virtual void on_control(ConnectionId from, const wire::pb::Control& message) = 0;
  virtual void on_frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message) = 0;
  /// Of these sensors it had to be left frames out.
  virtual void on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) = 0;
  /// The session is over; it is not used after this.
  virtual void on_left(ConnectionId from, const net::CloseReason& reason) = 0;
};

/// What one connection may send, by what it is.
struct SessionLimits {
  wire::SendingLimits sensor = wire::kMaxFromSensor;
  wire::SendingLimits viewer = wire::kMaxFromViewer;  // and who has not been taken in
  wire::SendingLimits hub = wire::kMaxFromHub;
  wire::SendingLimits aligner = wire::kMaxFromAligner;

  [[nodiscard]] const wire::SendingLimits& of(Role role) const;
};

class Session final : public net::ConnectionHandler {
 public:
  /// `connection` is used up to on_closed().
  Session(ConnectionId id, net::WebSocketConnection& connection, SessionEvents& hub,
          const Clock& clock, const SessionLimits& limits = {});

  void on_message(net::MessageBuffer message) override;
  net::FramedMessagePtr next_message() override;
  void on_closed(const net::CloseReason& reason) override;

  /// The room has taken it in.
  void accept(Role role);
  [[nodiscard]] std::uint64_t bytes_out() const { return connection_.counters().bytes_out; }
  [[nodiscard]] ConnectionId id() const { return id_; }
  [[nodiscard]] bool is_accepted() const { return is_accepted_; }
  /// It has asked to be taken in.
  [[nodiscard]] bool has_joined() const { return has_joined_; }

  /// False when the peer lets its control messages pile up: disconnect it.
  [[nodiscard]] bool send_control(net::FramedMessagePtr message);
  void send_set(FrameSetPtr set);
  [[nodiscard]] std::uint64_t dropped_sets() const { return send_queue_.dropped_sets(); }
  void restart_sensor(SensorId sensor) { send_queue_.forget(sensor); }

  /// Says why and closes. Nothing more comes from it but on_left.
  void disconnect(wire::pb::ErrorCode code, const std::string& sentence);

 private:
  void take_frame(net::MessageBuffer message);
  void take_control(std::span<const std::uint8_t> message);
  void tell_time(const wire::pb::ClockPing& ping);
  void refuse(const Error& error);
  void limit(const wire::SendingLimits& limits);

  const ConnectionId id_;
  net::WebSocketConnection& connection_;
  SessionEvents& hub_;
  const Clock& clock_;
  SendQueue send_queue_;
  const SessionLimits limits_;
  bool has_joined_ = false;
  bool is_accepted_ = false;
  bool is_sensor_ = false;  // by its own word; the room knows
  RateLimit messages_{0, 0}, bytes_{0, 0};
};

}  // namespace roomcast::hub
