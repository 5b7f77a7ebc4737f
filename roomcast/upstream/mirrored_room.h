// SPDX-License-Identifier: Apache-2.0
// MirroredRoom: brings the sensors of another hub's room into a room of this hub, as if each were
// connected here: rosters and frames of the other hub come in, what a sensor would say goes out.
// Frames keep their bytes but for the sensor's id, the time (of this hub's clock) and its error.
// A pose that somebody gave is given on; one that alignment found comes as an aligner's word, so
// that people here read the same. Pure but for whom it tells. Threading: the rooms' thread.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "roomcast/hub/session.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/room/clock_estimate.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::upstream {

class MirroredRoom {
 public:
  using NewConnection = std::function<ConnectionId()>;

  /// `here` is told; `token` lets anybody into its room, and it outlives this.
  MirroredRoom(std::string room, std::string token, hub::SessionEvents& here,
               NewConnection new_connection);

  // From the other hub. Its messages have passed wire::decode_control.
  void roster(const wire::pb::Roster& roster);
  void clock_is(const ClockEstimate& estimate) { clock_ = estimate; }
  /// Dropped while the clock, or the sensor's id here, are not known; what is no frame, too.
  void frame(net::MessageBuffer message);
  /// Until it comes back all sensors are gone.
  void other_hub_is_gone();

  // From the room here.
  /// To one of our connections. The message that the other hub should get, if any.
  std::optional<wire::pb::Control> said(ConnectionId to, const wire::pb::Control& message);
  /// It was sent away. Back with the next roster.
  void let_go(ConnectionId connection);

 private:
  struct Sensor {
    wire::pb::SensorEntry entry;  // there
    ConnectionId connection;      // here
    std::optional<SensorId> id;   // here, once it was welcomed
  };
  using Sensors = std::map<std::uint32_t, Sensor>;  // by their ids there

  void follow(const wire::pb::SensorEntry& entry);
  void join(const wire::pb::SensorEntry& entry);
  Sensors::iterator leave(Sensors::iterator sensor);
  ConnectionId join_as(wire::pb::Join join);
  void place_sensors();
  [[nodiscard]] Sensors::iterator find(ConnectionId connection);
  [[nodiscard]] RoomTime time_here(RoomTime there) const;

  const std::string room_, token_;
  hub::SessionEvents& here_;
  const NewConnection new_connection_;
  Sensors sensors_;
  std::optional<ConnectionId> aligner_;
  bool aligner_is_welcome_ = false;
  std::optional<ClockEstimate> clock_;
};

}  // namespace roomcast::upstream
