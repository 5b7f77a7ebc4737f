// SPDX-License-Identifier: Apache-2.0
// MirroredRoom: mirrors the sensors of another hub's room, with their poses, in a room of this hub.
// Poses estimated there are passed on as placements of an aligner, so that viewers here see the
// same status. People are mirrored in both directions. Pure except for its calls to `here`.
// Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/hub/federation/mirror/mirrored_sensors.h"
#include "roomcast/hub/federation/mirror/presence_relay.h"
#include "roomcast/hub/federation/mirror/shown_presence.h"

namespace roomcast::hub::federation {

class MirroredRoom {
 public:
  /// `here` gets the events and must outlive this; `token` admits any client to its room.
  MirroredRoom(std::string room, std::string token, hub::BackplaneEvents& here,
               NewConnection new_connection);

  // From the other hub. Its messages have passed wire::decode_control.
  /// The other hub has welcomed us as this viewer. Returns the messages to send to it at first.
  std::vector<wire::pb::Control> on_welcome(std::uint32_t viewer_id);
  void on_poses(const wire::pb::ViewerPoses& poses);
  void on_roster(const wire::pb::Roster& roster);
  void set_clock(const client::ClockEstimate& estimate) { sensors_.set_clock(estimate); }
  void frame(net::MessageBuffer message) { sensors_.frame(std::move(message)); }
  void frames_done() { sensors_.deliver_frames(); }
  /// Removes all sensors until the hub returns.
  void on_hub_lost();

  // From the room here.
  /// A message to one of our connections. Returns the message to send to the other hub, if any.
  std::optional<wire::pb::Control> on_room_message(ConnectionId to,
                                                   const wire::pb::Control& message);
  /// The connection was removed from the room. It rejoins with the next roster.
  void on_removed(ConnectionId connection);

 private:
  void join_as_aligner();
  void place_sensors();
  void show_people();
  std::optional<wire::pb::Control> on_aligner_message(const wire::pb::Control& message);

  const std::string room_, token_;
  hub::BackplaneEvents& here_;
  const NewConnection new_connection_;
  hub::federation::MirroredSensors sensors_;
  std::optional<ConnectionId> aligner_;
  bool aligner_is_welcome_ = false;
  std::uint32_t viewer_id_ = 0;  // our ID at the other hub
  wire::pb::PeopleHere people_there_;
  hub::federation::ShownPresence shown_presence_;  // people_there_ as last shown here
  hub::federation::PresenceRelay people_here_;
};

}  // namespace roomcast::hub::federation
