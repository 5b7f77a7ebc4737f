// SPDX-License-Identifier: Apache-2.0
// A sensor's settings as JSON (docs/spec/admin.openapi.yaml): {"codec": "live", "mbit": 2, "fps":
// 15}. The target rate is a number, 0 for none, or "auto". Threading: no state.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

[[nodiscard]] nlohmann::json to_json(const wire::pb::SensorSettings& settings);

/// The request in a body, which may also hold "restart". kInvalidArgument, with a sentence.
[[nodiscard]] Result<wire::pb::SettingsRequest> read_settings_request(const std::string& body);

/// For people: "codec lossless, 2 Mbit/s, restart".
[[nodiscard]] std::string described(const wire::pb::SettingsRequest& request);

}  // namespace roomcast::hub
