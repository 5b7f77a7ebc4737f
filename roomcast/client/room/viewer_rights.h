// SPDX-License-Identifier: Apache-2.0
// The rights that a room's owner grants a viewer. The hub sends them when the viewer joins;
// roomcast's programs respect them, others may not: see docs/threat-model.md.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::client {

struct ViewerRights {
  bool may_record = false;  // may keep pictures of the room: recordings, videos, stills
  bool may_export = false;  // may convert it into files of other programs: point clouds, meshes
  bool may_speak = false;
  bool may_mark = false;   // may leave marks
  bool may_place = false;  // may propose sensors' poses: joined with an admin's token
};

/// kUnavailable with a sentence: the room's owner has not granted this right.
[[nodiscard]] inline Status check_may_record(const ViewerRights& rights) {
  if (rights.may_record) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let viewers record"};
}
[[nodiscard]] inline Status check_may_export(const ViewerRights& rights) {
  if (rights.may_export) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let viewers export"};
}
[[nodiscard]] inline Status check_may_speak(const ViewerRights& rights) {
  if (rights.may_speak) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let you speak"};
}
[[nodiscard]] inline Status check_may_mark(const ViewerRights& rights) {
  if (rights.may_mark) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let you leave marks"};
}
[[nodiscard]] inline Status check_may_place(const ViewerRights& rights) {
  if (rights.may_place) return {};
  return Error{ErrorCode::kUnavailable,
               "to move a sensor takes an admin's token (roomcast token --role admin)"};
}

}  // namespace roomcast::client
