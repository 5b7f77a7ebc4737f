// SPDX-License-Identifier: Apache-2.0
// People who play recordings of a Room: they get voices of each other, and nothing of the room.
#include <utility>

#include "roomcast/hub/room/room.h"

namespace roomcast::hub {

namespace pb = wire::pb;

void Room::join_player(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now,
                       RoomActions& out) {
  if (is_full()) {
    out = refuse_as_full(from, now);
    return;
  }
  pb::Control welcome = welcome_message(entry);
  welcome.mutable_welcome()->set_may_speak(entry.may_speak);
  welcome.mutable_welcome()->set_viewer_id(next_viewer_id_);
  out.push_back(AcceptConnection{from, Role::kPlayer});
  out.push_back(SendControl{{from}, std::move(welcome)});
  const bool is_muted = !entry.token_id.empty() && muted_tokens_.contains(entry.token_id);
  playback_.add(from,
                {.id = ViewerId{next_viewer_id_},
                 .name = join.name(),
                 .recording = join.viewer().plays(),
                 .may_speak = entry.may_speak,
                 .hears = join.viewer().hears(),
                 .token_id = entry.token_id},
                is_muted, out);
  ++next_viewer_id_;
}

RoomActions Room::control_of_player(ConnectionId from, const pb::Control& message, RoomTime now) {
  switch (message.message_case()) {
    case pb::Control::kViewerPose: {
      const pb::Pose& head = message.viewer_pose().head();
      playback_.move(from, {head.x(), head.y(), head.z()});
      return {};
    }
    case pb::Control::kViewerStats:     // it shows nothing of this room
    case pb::Control::MESSAGE_NOT_SET:  // a message of a later protocol version
      return {};
    default:
      return refuse(from, pb::ERROR_UNEXPECTED,
                    "who plays a recording is not in the room, and changes nothing there", now);
  }
}

void Room::add_players_to(RoomStats& stats) const {
  stats.speakers += playback_.speaker_count();
  for (const auto& [connection, player] : playback_.all()) {
    stats.viewers.push_back({.id = player.id,
                             .name = player.name,
                             .connection = connection,
                             .token_id = player.token_id,
                             .plays = player.recording,
                             .may_speak = player.may_speak,
                             .speaks = playback_.is_speaking(player),
                             .muted = playback_.is_muted(player)});
  }
}

}  // namespace roomcast::hub
