// SPDX-License-Identifier: Apache-2.0
// PoseChangeDetector: detects within 2 s that its sensor was moved by at least 2 cm or half a
// degree. People who walk past and chairs that are pushed do not trigger it: it checks a picture
// every 400 ms, and reports a motion only if most of the room agrees in several consecutive checks.
// Single-threaded.
#pragma once

#include <optional>

#include "roomcast/alignment/motion/motion_check.h"
#include "roomcast/core/clock.h"

namespace roomcast::alignment {

/// Time between two checks.
inline constexpr std::chrono::milliseconds kCheckInterval{400};
/// Consecutive checks that must agree.
inline constexpr int kAgreeingChecks = 3;

/// After this many consecutive checks in which the background is hidden, the cause is not a person
/// in front of the sensor: the sensor was turned towards a near object.
inline constexpr int kBlindChecks = 25;

/// Whether this picture alone indicates that the sensor has moved; nothing if it is inconclusive,
/// as when a person is close in front of the sensor.
[[nodiscard]] std::optional<bool> indicates_motion(const MotionEvidence& evidence);

class PoseChangeDetector {
 public:
  /// `bundle` has passed check().
  explicit PoseChangeDetector(const CalibrationBundle& bundle) : check_(bundle) {}

  /// `depth_mm` has the bundle's size and was taken at `time`. Returns true if the sensor has
  /// moved. Most pictures are skipped.
  [[nodiscard]] bool moved(DepthView depth_mm, HostTime time);

 private:
  MotionCheck check_;
  std::optional<HostTime> last_look_;
  int in_a_row_ = 0;
  int blind_in_a_row_ = 0;
};

}  // namespace roomcast::alignment
