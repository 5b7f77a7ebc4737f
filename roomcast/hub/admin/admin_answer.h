// SPDX-License-Identifier: Apache-2.0
// The answers of the hub's HTTP interface: objects as JSON, and refusals with a code and a sentence
// (docs/spec/admin.openapi.yaml). Threading: no state.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/hub/store/hub_store.h"
#include "roomcast/net/http_response.h"

namespace roomcast::hub {

[[nodiscard]] net::HttpResponse json_answer(int status, const nlohmann::json& body);
[[nodiscard]] net::HttpResponse no_content();
[[nodiscard]] net::HttpResponse error_answer(int status, std::string_view code,
                                             const std::string& sentence);
[[nodiscard]] net::HttpResponse error_answer(const Refusal& why);
[[nodiscard]] net::HttpResponse error_answer(const Error& error);

/// For callers without admin rights: omits the owner's data.
[[nodiscard]] nlohmann::json brief_room(const RoomSettings& settings, const RoomStats& stats);
[[nodiscard]] nlohmann::json whole_room(const RoomSettings& settings, const RoomStats& stats);
[[nodiscard]] nlohmann::json sensor_json(const SensorStats& sensor, const std::string& address);
[[nodiscard]] nlohmann::json viewer_json(const ViewerStats& viewer, const std::string& address);
[[nodiscard]] nlohmann::json recording_json(const RoomRecording& recording);
[[nodiscard]] nlohmann::json kept_recording_json(const KeptRecording& recording);
[[nodiscard]] nlohmann::json token_json(const IssuedToken& token);

}  // namespace roomcast::hub
