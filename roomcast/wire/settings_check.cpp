// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/settings_check.h"

#include <string>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::wire {

Status check_settings(const pb::SensorSettings& settings) {
  if (auto s = check_name(settings.codec(), "codec"); !s) return s;
  if (!(settings.mbit() >= 0 && settings.mbit() <= kMaxTargetMbit))
    return Error{ErrorCode::kMalformed, "a target rate is 0 to 1000 Mbit/s"};
  if (settings.has_fps() && !(settings.fps() > 0 && settings.fps() <= kMaxFps))
    return Error{ErrorCode::kMalformed, "a frame rate is above 0 and at most 240 per second"};
  return {};
}

Status check_settings_answer(const pb::SettingsAnswer& answer) {
  if (answer.refusal().size() <= kMaxNoteBytes) return {};
  return Error{ErrorCode::kTooLarge,
               "a refusal must have at most " + std::to_string(kMaxNoteBytes) + " bytes"};
}

}  // namespace roomcast::wire
