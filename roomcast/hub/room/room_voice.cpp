// SPDX-License-Identifier: Apache-2.0
// Voice in a Room: who may send audio packets, who gets and records them, and who is muted.
#include <utility>

#include "roomcast/hub/room/room.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace pb = wire::pb;

RoomActions Room::audio(ConnectionId from, const wire::AudioHeader& header,
                        net::MessageBuffer message, RoomTime now) {
  const auto found = viewers_.find(from);
  if (found == viewers_.end() || !found->second.may_speak) {
    return refuse(from, pb::ERROR_NOT_ALLOWED, "the rules of this room do not let you speak", now);
  }
  if (header.capture_time > now + wire::kMaxCaptureAhead) {
    return refuse(from, pb::ERROR_MALFORMED,
                  "this audio was recorded in the future: synchronise the clock first", now);
  }
  const ViewerId speaker = found->second.id;
  ++set_stats_.audio_packets;
  RoomActions out;
  auto to = voices_.receivers(speaker, header.ends, now,
                              [this](ViewerId viewer) { return poses_.head_of(viewer); });
  if (to.empty()) return out;
  wire::stamp_speaker(message.payload(), speaker);
  out.push_back(SendAudio{std::move(to), speaker, net::frame_message(std::move(message))});
  return out;
}

RoomActions Room::mute(ViewerId viewer, bool muted, RoomTime now) {
  for (const auto& [connection, entry] : viewers_) {
    if (entry.id != viewer || entry.token_id.empty()) continue;
    muted ? void(muted_tokens_.insert(entry.token_id)) : void(muted_tokens_.erase(entry.token_id));
  }
  voices_.set_muted(viewer, muted);
  return tick(now);
}

/// Tells the viewer who speaks, if it wants to hear; and mutes it if it was muted before.
void Room::add_voice(ConnectionId connection, const Viewer& viewer, RoomActions& out) {
  if (!viewer.token_id.empty() && muted_tokens_.contains(viewer.token_id))
    voices_.set_muted(viewer.id, true);
  if (!may_hear(viewer)) return;
  voices_.add_listener(viewer.id, connection, viewer.records ? Hearing::kAll : Hearing::kNearest);
  out.push_back(SendControl{{connection}, voices_.message()});
}

/// It wants to, and does not keep voices in a room whose owner forbids it.
bool Room::may_hear(const Viewer& viewer) const {
  return viewer.hears && (!viewer.records || settings_.record_voices);
}

void Room::change_recorded_voices(RoomTime now, RoomActions& out) {
  for (const auto& [connection, viewer] : viewers_) {
    if (!viewer.records || !viewer.hears) continue;
    voices_.forget(viewer.id);
    add_voice(connection, viewer, out);
  }
  send_roster_when_due(now, out);
}

void Room::send_voices(RoomTime now, RoomActions& out) {
  auto voices = voices_.take(now);
  if (!voices) return;
  if (auto to = voices_.listeners(); !to.empty())
    out.push_back(SendControl{std::move(to), *std::move(voices)});
}

}  // namespace roomcast::hub
