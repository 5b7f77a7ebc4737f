// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/playback_voices.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub {

void PlaybackVoices::add(ConnectionId connection, Player player, bool is_muted, RoomActions& out) {
  VoiceRelay& relay = relays_[player.recording];
  if (is_muted) relay.set_muted(player.id, true);
  if (player.hears) {
    relay.add_listener(player.id, connection);
    out.push_back(SendControl{{connection}, relay.message()});
  }
  players_[connection] = std::move(player);
}

bool PlaybackVoices::remove(ConnectionId connection) {
  const auto found = players_.find(connection);
  if (found == players_.end()) return false;
  const Player gone = std::move(found->second);
  players_.erase(found);
  relays_.at(gone.recording).forget(gone.id);
  const auto plays_the_same = [&gone](const auto& other) {
    return other.second.recording == gone.recording;
  };
  if (std::ranges::none_of(players_, plays_the_same)) relays_.erase(gone.recording);
  return true;
}

const PlaybackVoices::Player* PlaybackVoices::find(ConnectionId connection) const {
  const auto found = players_.find(connection);
  return found == players_.end() ? nullptr : &found->second;
}

const PlaybackVoices::Player* PlaybackVoices::find(ViewerId player) const {
  const auto found =
      std::ranges::find_if(players_, [player](const auto& p) { return p.second.id == player; });
  return found == players_.end() ? nullptr : &found->second;
}

void PlaybackVoices::move(ConnectionId connection, const Eigen::Vector3f& head) {
  if (const auto found = players_.find(connection); found != players_.end())
    found->second.head = head;
}

void PlaybackVoices::set_muted(const Player& player, bool muted) {
  relays_.at(player.recording).set_muted(player.id, muted);
}

std::vector<ConnectionId> PlaybackVoices::receivers(const Player& speaker, bool ends,
                                                    RoomTime now) {
  const auto head_of = [this](ViewerId id) {
    const Player* player = find(id);
    return player == nullptr ? std::nullopt : player->head;
  };
  return relays_.at(speaker.recording).receivers(speaker.id, ends, now, head_of);
}

void PlaybackVoices::send_voices(RoomTime now, RoomActions& out) {
  for (auto& [recording, relay] : relays_) {
    auto voices = relay.take(now);
    if (!voices) continue;
    if (auto to = relay.listeners(); !to.empty())
      out.push_back(SendControl{std::move(to), *std::move(voices)});
  }
}

std::optional<RoomTime> PlaybackVoices::next() const {
  std::optional<RoomTime> next;
  for (const auto& [recording, relay] : relays_) {
    const auto due = relay.next();
    if (due && (!next || *due < *next)) next = due;
  }
  return next;
}

std::size_t PlaybackVoices::speaker_count() const {
  std::size_t count = 0;
  for (const auto& [recording, relay] : relays_) count += relay.speaker_count();
  return count;
}

bool PlaybackVoices::is_speaking(const Player& player) const {
  return relay_of(player).is_speaking(player.id);
}

bool PlaybackVoices::is_muted(const Player& player) const {
  return relay_of(player).is_muted(player.id);
}

const VoiceRelay& PlaybackVoices::relay_of(const Player& player) const {
  return relays_.at(player.recording);
}

}  // namespace roomcast::hub
