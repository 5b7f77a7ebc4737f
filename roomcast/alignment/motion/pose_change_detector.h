// SPDX-License-Identifier: Apache-2.0
// PoseChangeDetector: notices that its sensor was moved, by 2 cm or half a degree and more, within
// 2 s, and keeps quiet about people who walk past and chairs that are pushed. It looks at a picture
// now and then; only what most of the room says, several looks in a row, counts. Single-threaded.
#pragma once

#include <optional>

#include "roomcast/alignment/motion/motion_check.h"
#include "roomcast/core/clock.h"

namespace roomcast::alignment {

/// Between two looks.
inline constexpr std::chrono::milliseconds kLookInterval{400};
/// That have to agree.
inline constexpr int kLooksInARow = 3;

/// After so many that tell nothing, because all that was there is hidden, it is not somebody
/// standing before the sensor: it was turned towards something close.
inline constexpr int kBlindLooksInARow = 25;

/// Whether this picture alone says that the sensor has moved; nothing when it cannot tell, as when
/// somebody stands right before it.
[[nodiscard]] std::optional<bool> says_moved(const MotionEvidence& evidence);

class PoseChangeDetector {
 public:
  /// `bundle` has passed check().
  explicit PoseChangeDetector(const CalibrationBundle& bundle) : check_(bundle) {}

  /// Takes a picture of the bundle's size, taken at `time`. True: the sensor has moved. Most
  /// pictures are not even looked at.
  [[nodiscard]] bool moved(DepthView depth_mm, HostTime time);

 private:
  MotionCheck check_;
  std::optional<HostTime> last_look_;
  int in_a_row_ = 0;
  int blind_in_a_row_ = 0;
};

}  // namespace roomcast::alignment
