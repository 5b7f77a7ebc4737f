// SPDX-License-Identifier: Apache-2.0
// Session: one connection of a hub. Decodes messages into events of the room, queues messages to be
// written, and answers clock pings. Threading: its shard's event loop.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/access/rate_limit.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/hub/room/small_needs.h"
#include "roomcast/hub/runtime/connection.h"
#include "roomcast/hub/runtime/send_queue.h"
#include "roomcast/net/websocket_connection.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.pb.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// A connection that asks to join.
struct ConnectionInfo {
  ConnectionPtr connection;
  std::string address;  // "192.0.2.7:50312"
  std::string peer;     // for counting and banning
  /// For a sensor that a backplane represents: the ID of the token that it presented to its own
  /// hub.
  std::optional<std::string> token_id_there = {};
  std::uint64_t other_hub = 0;  // the hub to which the sensor is connected; 0: this hub
  bool is_backplane = false;    // a backplane's, which represents sensors or people of other hubs

  [[nodiscard]] ConnectionId id() const { return connection->id(); }
};

/// Events of sessions: a session reports them to its shard, and the shard to the room.
class SessionEvents {
 public:
  virtual ~SessionEvents() = default;
  /// Called once for each session, before all other events.
  virtual void on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) = 0;
  virtual void on_control(ConnectionId from, const wire::pb::Control& message) = 0;
  virtual void on_frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message) = 0;
  /// A viewer speaks. By default it is ignored: backplanes bring in none.
  virtual void on_audio(ConnectionId /*from*/, const wire::AudioHeader& /*header*/,
                        net::MessageBuffer /*message*/) {}
  /// Frames of these sensors were dropped for this connection.
  virtual void on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) = 0;
  /// What a viewer with a slow line needs of small renditions has changed. By default it is
  /// ignored: backplanes have no viewers.
  virtual void on_small_needs(ConnectionId /*from*/, const SmallNeeds& /*needs*/) {}
  /// The session is over; it is not used after this.
  virtual void on_left(ConnectionId from, const net::CloseReason& reason) = 0;
};

/// The sending limits of a connection, by role.
struct SessionLimits {
  wire::SendingLimits sensor = wire::kMaxFromSensor;
  wire::SendingLimits viewer = wire::kMaxFromViewer;  // also before a connection is accepted
  wire::SendingLimits hub = wire::kMaxFromHub;
  wire::SendingLimits aligner = wire::kMaxFromAligner;
  wire::SendingLimits speaker = wire::kMaxFromSpeaker;  // of a viewer's messages, its audio

  [[nodiscard]] const wire::SendingLimits& of(Role role) const;
};

class Session final : public net::ConnectionHandler {
 public:
  /// `in_room`: this session as its room sees it. `connection` must be valid until on_closed().
  Session(ConnectionPtr in_room, net::WebSocketConnection& connection, SessionEvents& hub,
          const Clock& clock, const SessionLimits& limits = {});

  void on_message(net::MessageBuffer message) override;
  net::FramedMessagePtr next_message() override;
  void on_closed(const net::CloseReason& reason) override;

  /// The room has accepted the connection in this role.
  void accept(Role role);
  [[nodiscard]] std::uint64_t bytes_out() const { return connection_.counters().bytes_out; }
  [[nodiscard]] ConnectionId id() const { return in_room_->id(); }
  [[nodiscard]] bool is_accepted() const { return is_accepted_; }
  /// A Join has arrived.
  [[nodiscard]] bool has_joined() const { return has_joined_; }

  /// False: too many control messages are unread; disconnect the peer.
  [[nodiscard]] bool send_control(net::FramedMessagePtr message);
  void send_set(FrameSetPtr set);
  void send_audio(ViewerId speaker, net::FramedMessagePtr packet);
  [[nodiscard]] std::uint64_t dropped_sets() const { return send_queue_.dropped_sets(); }
  [[nodiscard]] std::uint64_t dropped_audio() const { return send_queue_.dropped_audio(); }
  void set_details(SensorDetails details) { send_queue_.set_details(std::move(details)); }
  void restart_sensor(SensorId sensor) { send_queue_.forget(sensor); }

  /// Sends the reason and closes. on_left is the only event after this.
  void disconnect(wire::pb::ErrorCode code, const std::string& sentence);

 private:
  void take_frame(net::MessageBuffer message);
  void take_audio(net::MessageBuffer message);
  void take_control(std::span<const std::uint8_t> message);
  void answer_clock_ping(const wire::pb::ClockPing& ping);
  void refuse(const Error& error);
  void limit(const wire::SendingLimits& limits);

  const ConnectionPtr in_room_;
  net::WebSocketConnection& connection_;
  SessionEvents& hub_;
  const Clock& clock_;
  SendQueue send_queue_;
  const SessionLimits limits_;
  bool has_joined_ = false;
  bool is_accepted_ = false;
  bool is_sensor_ = false;  // as stated in its Join; the room decides
  RateLimit messages_{0, 0}, bytes_{0, 0};
  RateLimit audio_packets_, audio_bytes_;
};

}  // namespace roomcast::hub
