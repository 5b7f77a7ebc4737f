// SPDX-License-Identifier: Apache-2.0
// Decides whether a client may join a room, and in which role. Pure: takes the Join, the claims of
// its token and the room's settings, and returns the permissions or a refusal.
//
// A client without a token for a private room (unlisted, and requiring tokens) gets the same answer
// as for a room that does not exist.
#pragma once

#include <functional>
#include <string>

#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// The permissions of an admitted client.
struct Entry {
  std::string room = {};
  std::string token_id = {};     // of the token that it joined with
  UnixSeconds expires_at = 0;    // of that token; 0: never
  bool may_place = false;        // set sensor poses
  bool may_record = false;       // record the streams that it gets
  bool may_share = false;        // and pass recordings on
  bool may_speak = false;        // send audio packets
  bool may_mark = false;         // leave marks in the room
  bool takes_over_name = false;  // the sensor may replace an online one of the same name
  std::string new_token = {};    // issued in exchange for a code
  std::uint64_t other_hub = 0;   // the hub of a sensor that a backplane represents; 0: this hub
  bool is_backplane = false;     // a backplane's connection
};

/// Returns null if there is no such room.
using FindRoom = std::function<const RoomSettings*(const std::string& name)>;

/// `claims` null: no token was presented. `only_listed_room`: the room for an empty name if the
/// token names none; empty unless the hub has exactly one listed room.
[[nodiscard]] Verdict<Entry> decide_entry(const wire::pb::Join& join, const Claims* claims,
                                          const FindRoom& find_room,
                                          const std::string& only_listed_room);

/// Whether a client with these claims (null: none) may learn that this room exists.
[[nodiscard]] bool may_know_of(const RoomSettings& room, const Claims* claims);

/// The refusal of a room that does not exist, and of one that the client may not know of.
[[nodiscard]] Refusal no_such_room();

/// Whether a client with these claims (null: none) may see what viewers of this room see.
[[nodiscard]] bool may_view(const RoomSettings& room, const Claims* claims);

}  // namespace roomcast::hub
