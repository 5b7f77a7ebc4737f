// SPDX-License-Identifier: Apache-2.0
// What pages that play a recording together say and are told, as JSON (docs/spec/playback.md).
// Threading: no state.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/runtime/watch_party.h"

namespace roomcast::hub {

/// kInvalidArgument, with a sentence.
[[nodiscard]] Result<WatcherState> read_watcher(const std::string& body);

[[nodiscard]] nlohmann::json watch_party_json(const WatchParties::View& view);

}  // namespace roomcast::hub
