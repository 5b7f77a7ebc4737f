// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/entry.h"

#include <optional>

namespace roomcast::hub {

namespace {

namespace pb = wire::pb;

std::string wanted_room(const pb::Join& join, const Claims* claims,
                        const std::string& only_listed_room) {
  if (!join.room().empty()) return join.room();
  const bool for_one_room = claims != nullptr && claims->grant.room != kAllRooms;
  return for_one_room ? claims->grant.room : only_listed_room;
}

/// Whether these claims meet the requirement `rule`. Admins may do everything except kNobody.
bool meets(AccessRule rule, const Claims* claims, std::optional<TokenRole> role = std::nullopt) {
  const bool is_admin = claims != nullptr && claims->grant.role == TokenRole::kAdmin;
  switch (rule) {
    case AccessRule::kAnyone:
      return true;
    case AccessRule::kToken:
      return is_admin || (claims != nullptr && (!role || claims->grant.role == *role));
    case AccessRule::kAdmin:
      return is_admin;
    case AccessRule::kNobody:
      break;
  }
  return false;
}

struct RequiredAccess {
  AccessRule rule = AccessRule::kAdmin;  // is permitted
  TokenRole role = TokenRole::kAdmin;
  const char* what = "";  // verb for the refusal
};

RequiredAccess required_of(const pb::Join& join, const RoomSettings& room) {
  switch (join.role_case()) {
    case pb::Join::kSensor:
      return {room.send, TokenRole::kSensor, "send"};
    case pb::Join::kViewer:
      if (!join.viewer().plays().empty())
        return {AccessRule::kAdmin, TokenRole::kAdmin, "play recordings of"};
      if (join.viewer().relays()) return {room.view, TokenRole::kHub, "relay"};
      return {room.view, TokenRole::kViewer, "view"};
    case pb::Join::kModeler:
      return {AccessRule::kAdmin, TokenRole::kAdmin, "fuse a model of"};
    default:
      return {AccessRule::kAdmin, TokenRole::kAdmin, "place sensors in"};
  }
}

Refusal refuse(const RequiredAccess& required, const Claims* claims) {
  const std::string what = required.what;
  if (required.rule == AccessRule::kNobody) {
    return {pb::ERROR_NOT_ALLOWED, "nobody may " + what + " this room"};
  }
  const std::string needed(
      name_of(required.rule == AccessRule::kAdmin ? TokenRole::kAdmin : required.role));
  if (claims == nullptr) {
    return {pb::ERROR_UNAUTHENTICATED, "to " + what + " this room takes a token for role " +
                                           needed + "; ask its owner for one"};
  }
  return {pb::ERROR_WRONG_ROLE, "this token is for role " +
                                    std::string(name_of(claims->grant.role)) + "; to " + what +
                                    " this room takes one for role " + needed};
}

bool is_another_sensors(const pb::Join& join, const Claims* claims) {
  return join.has_sensor() && claims != nullptr && claims->grant.role == TokenRole::kSensor &&
         !claims->grant.name.empty() && claims->grant.name != join.name();
}

Entry entry_of(const pb::Join& join, const Claims* claims, const RoomSettings& room) {
  Entry entry{.room = room.name};
  entry.may_record = meets(room.record, claims);
  entry.may_share = meets(room.share, claims);
  const bool is_person = join.has_viewer() && !join.viewer().records() && !join.viewer().relays();
  entry.may_speak = (is_person || join.has_sensor()) && meets(room.speak, claims);
  entry.may_mark = meets(room.mark, claims);
  if (claims == nullptr) return entry;
  entry.token_id = claims->id;
  entry.expires_at = claims->expires_at;
  entry.may_place = claims->grant.role == TokenRole::kAdmin;
  entry.takes_over_name = entry.may_place || claims->grant.name == join.name();
  return entry;
}

}  // namespace

Refusal no_such_room() {
  return {pb::ERROR_NO_SUCH_ROOM,
          "this hub has no such room, or the room needs a token of its own"};
}

bool may_know_of(const RoomSettings& room, const Claims* claims) {
  return room.listed || (claims != nullptr && covers(claims->grant, room.name));
}

bool may_view(const RoomSettings& room, const Claims* claims) {
  const bool is_of_room = claims != nullptr && covers(claims->grant, room.name);
  return meets(room.view, is_of_room ? claims : nullptr, TokenRole::kViewer);
}

Verdict<Entry> decide_entry(const pb::Join& join, const Claims* claims, const FindRoom& find_room,
                            const std::string& only_listed_room) {
  const std::string name = wanted_room(join, claims, only_listed_room);
  if (name.empty()) {
    return Refusal{pb::ERROR_NO_SUCH_ROOM, "this hub has several rooms: say which one"};
  }
  if (claims != nullptr && !covers(claims->grant, name)) {
    return Refusal{pb::ERROR_WRONG_ROOM, "this token is for another room"};
  }
  const RoomSettings* room = find_room(name);
  if (room == nullptr) return no_such_room();
  const RequiredAccess required = required_of(join, *room);
  if (!meets(required.rule, claims, required.role)) {
    return may_know_of(*room, claims) ? refuse(required, claims) : no_such_room();
  }
  if (is_another_sensors(join, claims)) {
    return Refusal{pb::ERROR_WRONG_ROLE,
                   "this token is for the sensor \"" + claims->grant.name + "\" and no other"};
  }
  if (join.viewer().records() && !meets(room->record, claims)) {
    return Refusal{pb::ERROR_NOT_ALLOWED, "this room's owner does not let you record it"};
  }
  return entry_of(join, claims, *room);
}

}  // namespace roomcast::hub
