// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/camera_settings.h"

namespace roomcast::source {

Status CameraSettings::check() const {
  if (trigger_delay < trigger_delay.zero() || trigger_delay > kLongestTriggerDelay)
    return Error{ErrorCode::kInvalidArgument, "the trigger delay must be 0 to 1000000 us"};
  if (trigger_delay.count() > 0 && sync != SyncRole::kSecondary) {
    return Error{ErrorCode::kInvalidArgument,
                 "a trigger delay is for a secondary camera; add --sync secondary"};
  }
  return {};
}

Status check_abilities(const std::string& kind, const CameraAbilities& abilities,
                       const CameraSettings& settings) {
  const auto cannot = [&](const char* what) {
    return Error{ErrorCode::kUnsupported, kind + " cameras cannot " + what};
  };
  if (settings.lock_exposure && !abilities.lock_exposure) return cannot("lock their exposure");
  if (settings.lock_white_balance && !abilities.lock_white_balance)
    return cannot("lock their white balance");
  if (settings.sync != SyncRole::kAlone && !abilities.sync)
    return cannot("be synchronised by a cable");
  if (settings.trigger_delay.count() > 0 && !abilities.trigger_delay)
    return cannot("delay their trigger");
  return {};
}

}  // namespace roomcast::source
