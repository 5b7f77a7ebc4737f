// SPDX-License-Identifier: Apache-2.0
// Camera settings for several cameras in one room, and the abilities of a kind of camera.
// Thread-safe (no state).
#pragma once

#include <chrono>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// Hardware synchronisation over a cable: the primary triggers the secondaries.
enum class SyncRole { kAlone, kPrimary, kSecondary };

struct CameraSettings {
  /// Lock automatic exposure once it has converged: pictures of several sensors stay alike.
  bool lock_exposure = false;
  bool lock_white_balance = false;
  SyncRole sync = SyncRole::kAlone;
  /// Delay of a secondary's exposure after the primary's. Time-of-flight cameras that see the same
  /// surface disturb each other unless their pulses are staggered, by 160 us for the Azure Kinect
  /// (its documentation of external synchronisation).
  std::chrono::microseconds trigger_delay{0};
  bool loop = true;  // files: restart at the end

  /// Returns kInvalidArgument for a negative delay, one of more than a second, or a delay for a
  /// camera that is not a secondary.
  [[nodiscard]] Status check() const;
};

struct CameraAbilities {
  bool lock_exposure = false;
  bool lock_white_balance = false;
  bool sync = false;
  bool trigger_delay = false;
};

inline constexpr std::chrono::microseconds kLongestTriggerDelay{1'000'000};

/// Returns kUnsupported for the first unsupported setting: "freenect cameras cannot lock their
/// exposure". `kind`: "freenect".
[[nodiscard]] Status check_abilities(const std::string& kind, const CameraAbilities& abilities,
                                     const CameraSettings& settings);

}  // namespace roomcast::source
