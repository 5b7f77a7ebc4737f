// SPDX-License-Identifier: Apache-2.0
// What a user may ask of a camera where several watch one room, and which of it a kind of camera
// can do. Thread-safe (no state).
#pragma once

#include <chrono>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// Hardware synchronisation over a cable: the primary gives the beat.
enum class SyncRole { kAlone, kPrimary, kSecondary };

struct CameraSettings {
  /// Once automatic exposure has settled, keep it: pictures of several sensors stay alike.
  bool lock_exposure = false;
  bool lock_white_balance = false;
  SyncRole sync = SyncRole::kAlone;
  /// How much later than the primary's a secondary's exposure begins. Time-of-flight cameras that
  /// look at the same surface disturb each other unless their pulses are staggered, by 160 us for
  /// the Azure Kinect (its documentation of external synchronisation).
  std::chrono::microseconds trigger_delay{0};
  bool loop = true;  // files: start again at the end

  /// kInvalidArgument: a delay without a beat to be late for, or one of more than a second.
  [[nodiscard]] Status check() const;
};

struct CameraAbilities {
  bool lock_exposure = false;
  bool lock_white_balance = false;
  bool sync = false;
  bool trigger_delay = false;
};

inline constexpr std::chrono::microseconds kLongestTriggerDelay{1'000'000};

/// kUnsupported: "freenect cameras cannot lock their exposure" for the one that was asked for in
/// vain. `kind`: "freenect".
[[nodiscard]] Status check_abilities(const std::string& kind, const CameraAbilities& abilities,
                                     const CameraSettings& settings);

}  // namespace roomcast::source
