// SPDX-License-Identifier: Apache-2.0
// Checks the messages by which a sensor's settings are changed from afar: docs/spec/wire.md §3 and
// §4.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// Codecs of later versions are accepted: only the sensor knows which it has.
[[nodiscard]] Status check_settings(const pb::SensorSettings& settings);
[[nodiscard]] Status check_settings_answer(const pb::SettingsAnswer& answer);

}  // namespace roomcast::wire
