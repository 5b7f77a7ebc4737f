// SPDX-License-Identifier: Apache-2.0
// MirroredRoom: brings the sensors of another hub's room into a room of this hub, poses included:
// what alignment found there comes as an aligner's word, so that people here read the same. It
// brings the people, too, who see each other here and there. Pure but for whom it tells.
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
  using NewConnection = hub::federation::MirroredSensors::NewConnection;

  /// `here` is told; `token` lets anybody into its room, and it outlives this.
  MirroredRoom(std::string room, std::string token, hub::BackplaneEvents& here,
               NewConnection new_connection);

  // From the other hub. Its messages have passed wire::decode_control.
  /// We are this viewer there. What it should be told first.
  std::vector<wire::pb::Control> welcomed(std::uint32_t viewer_id);
  void poses(const wire::pb::ViewerPoses& poses);
  void roster(const wire::pb::Roster& roster);
  void clock_is(const client::ClockEstimate& estimate) { sensors_.clock_is(estimate); }
  void frame(net::MessageBuffer message) { sensors_.frame(std::move(message)); }
  void frames_done() { sensors_.pass_on(); }
  /// Until it comes back all sensors are gone.
  void other_hub_is_gone();

  // From the room here.
  /// To one of our connections. The message that the other hub should get, if any.
  std::optional<wire::pb::Control> said(ConnectionId to, const wire::pb::Control& message);
  /// It was sent away. Back with the next roster.
  void let_go(ConnectionId connection);

 private:
  void join_as_aligner();
  void place_sensors();
  void show_people();
  std::optional<wire::pb::Control> said_to_aligner(const wire::pb::Control& message);

  const std::string room_, token_;
  hub::BackplaneEvents& here_;
  const NewConnection new_connection_;
  hub::federation::MirroredSensors sensors_;
  std::optional<ConnectionId> aligner_;
  bool aligner_is_welcome_ = false;
  std::uint32_t viewer_id_ = 0;  // ours there
  wire::pb::PeopleHere people_there_;
  hub::federation::ShownPresence shown_presence_;  // of these, here
  hub::federation::PresenceRelay people_here_;
};

}  // namespace roomcast::hub::federation
