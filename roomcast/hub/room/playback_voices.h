// SPDX-License-Identifier: Apache-2.0
// PlaybackVoices: people who play recordings of a room, and are heard by those who play the same
// one. They are not in the room: nobody there hears or sees them. Pure. docs/spec/wire.md §6.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/hub/room/voice_relay.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class PlaybackVoices {
 public:
  struct Player {
    ViewerId id;
    std::string name;
    std::string recording;
    bool may_speak = false;
    bool hears = false;
    std::string token_id;
    std::optional<Eigen::Vector3f> head = {};  // metres, world frame of the recording
  };

  /// Tells the player, if it hears, who speaks and who is muted.
  void add(ConnectionId connection, Player player, bool is_muted, RoomActions& out);
  /// False: this connection is none of a player.
  bool remove(ConnectionId connection);
  /// Null: this connection is none of a player.
  [[nodiscard]] const Player* find(ConnectionId connection) const;
  [[nodiscard]] const Player* find(ViewerId player) const;
  void move(ConnectionId connection, const Eigen::Vector3f& head);
  /// The player must be here.
  void set_muted(const Player& player, bool muted);

  /// A packet of a player has come. Returns the connections that get it.
  [[nodiscard]] std::vector<ConnectionId> receivers(const Player& speaker, bool ends, RoomTime now);

  /// Tells listeners who speaks, where that has changed and is due.
  void send_voices(RoomTime now, RoomActions& out);
  [[nodiscard]] std::optional<RoomTime> next() const;

  [[nodiscard]] std::size_t count() const { return players_.size(); }
  [[nodiscard]] std::size_t speaker_count() const;
  [[nodiscard]] const std::unordered_map<ConnectionId, Player>& all() const { return players_; }
  [[nodiscard]] bool is_speaking(const Player& player) const;
  [[nodiscard]] bool is_muted(const Player& player) const;

 private:
  [[nodiscard]] const VoiceRelay& relay_of(const Player& player) const;

  std::unordered_map<ConnectionId, Player> players_;
  std::map<std::string, VoiceRelay> relays_;  // of each recording that somebody plays
};

}  // namespace roomcast::hub
