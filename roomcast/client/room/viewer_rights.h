// SPDX-License-Identifier: Apache-2.0
// What a room's owner lets a viewer keep of it. The hub says it when a viewer joins; our programs
// keep to it, others may not: see docs/threat-model.md.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::client {

struct ViewerRights {
  bool may_record = false;  // keep pictures of the room: recordings, videos, stills
  bool may_export = false;  // turn it into files of other programs: point clouds, meshes
};

/// kUnavailable, in a sentence, where the room's owner does not let this viewer.
[[nodiscard]] inline Status check_may_record(const ViewerRights& rights) {
  if (rights.may_record) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let viewers record"};
}
[[nodiscard]] inline Status check_may_export(const ViewerRights& rights) {
  if (rights.may_export) return {};
  return Error{ErrorCode::kUnavailable, "this room does not let viewers export"};
}

}  // namespace roomcast::client
