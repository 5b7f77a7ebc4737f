// SPDX-License-Identifier: Apache-2.0
// Voice in a Room: who may send audio packets, who gets and records them, and who is muted.
#include <utility>

#include "roomcast/hub/room/room.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace pb = wire::pb;

/// Nothing: who is there may not speak.
std::optional<ViewerId> Room::speaker_at(ConnectionId from) {
  if (RoomSensor* sensor = sensors_.find(from); sensor != nullptr && sensor->may_speak) {
    sensor->has_spoken = true;
    return wire::speaker_of(sensor->id);
  }
  if (const auto* player = playback_.find(from))
    return player->may_speak ? std::optional(player->id) : std::nullopt;
  const auto viewer = viewers_.find(from);
  if (viewer == viewers_.end() || !viewer->second.may_speak) return std::nullopt;
  return viewer->second.id;
}

/// A sensor whose pose is not known is somewhere in the room.
std::optional<Eigen::Vector3f> Room::place_of(ViewerId speaker) {
  if (const auto id = wire::sensor_of(speaker)) {
    const RoomSensor* sensor = sensors_.find(*id);
    if (sensor == nullptr || !sensor->pose.is_placed()) return std::nullopt;
    return sensor->pose.world_from_depth.translation_m.cast<float>();
  }
  const pb::Pose* head = poses_.head_of(speaker);
  if (head == nullptr) return std::nullopt;
  return Eigen::Vector3f(head->x(), head->y(), head->z());
}

RoomActions Room::audio(ConnectionId from, const wire::AudioHeader& header,
                        net::MessageBuffer message, RoomTime now) {
  const auto speaking = speaker_at(from);
  if (!speaking) {
    return refuse(from, pb::ERROR_NOT_ALLOWED, "the rules of this room do not let you speak", now);
  }
  if (header.capture_time > now + wire::kMaxCaptureAhead) {
    return refuse(from, pb::ERROR_MALFORMED,
                  "this audio was recorded in the future: synchronise the clock first", now);
  }
  const ViewerId speaker = *speaking;
  ++set_stats_.audio_packets;
  RoomActions out;
  const auto* player = playback_.find(from);
  auto to = player != nullptr
                ? playback_.receivers(*player, header.ends, now)
                : voices_.receivers(speaker, header.ends, now,
                                    [this](ViewerId anybody) { return place_of(anybody); });
  if (to.empty()) return out;
  wire::stamp_speaker(message.payload(), speaker);
  out.push_back(SendAudio{std::move(to), speaker, net::frame_message(std::move(message))});
  return out;
}

RoomActions Room::mute(ViewerId speaker, bool muted, RoomTime now) {
  const auto* player = playback_.find(speaker);
  if (player != nullptr) mute_token(player->token_id, muted);
  for (const auto& [connection, viewer] : viewers_) {
    if (viewer.id == speaker) mute_token(viewer.token_id, muted);
  }
  player != nullptr ? playback_.set_muted(*player, muted) : voices_.set_muted(speaker, muted);
  return tick(now);
}

/// Mutes also those who join with this token later.
void Room::mute_token(const std::string& token_id, bool muted) {
  if (token_id.empty()) return;
  muted ? void(muted_tokens_.insert(token_id)) : void(muted_tokens_.erase(token_id));
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
