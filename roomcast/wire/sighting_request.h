// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// Whether the request is for any kind of sightings.
[[nodiscard]] inline bool wants_any(const pb::SightingRequest& request) {
  return request.heads() || request.tags() || request.instants();
}

}  // namespace roomcast::wire
