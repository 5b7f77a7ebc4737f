// SPDX-License-Identifier: Apache-2.0
// Who may come into which room as what. Pure: what a Join asks for, what its token says and what
// the room's owner decided go in; what it may do, or why not, comes out.
//
// Whoever has no token for a private room (not listed, and asking for tokens) gets the very answer
// that a room gets which does not exist.
#pragma once

#include <functional>
#include <string>

#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// What somebody may do who was let in.
struct Entry {
  std::string room = {};
  std::string token_id = {};     // of the token that it came with
  UnixSeconds expires_at = 0;    // of that token; 0: stays as long as it likes
  bool may_place = false;        // say where sensors stand
  bool may_record = false;       // keep what it is sent
  bool may_share = false;        // and hand it on
  bool takes_over_name = false;  // a sensor that may replace another of its name
  std::string new_token = {};    // in exchange for a code
  std::uint64_t other_hub = 0;   // at which the sensor is, for which a backplane speaks; 0: here
};

/// Null: there is no such room.
using FindRoom = std::function<const RoomSettings*(const std::string& name)>;

/// `claims` null: no token was shown. `only_listed_room`: what an empty name means to whoever has
/// none; empty when there is not exactly one.
[[nodiscard]] Verdict<Entry> decide_entry(const wire::pb::Join& join, const Claims* claims,
                                          const FindRoom& find_room,
                                          const std::string& only_listed_room);

/// May whoever has these claims (null: none) know that this room exists?
[[nodiscard]] bool may_know_of(const RoomSettings& room, const Claims* claims);

}  // namespace roomcast::hub
