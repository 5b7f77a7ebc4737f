// SPDX-License-Identifier: Apache-2.0
// Whether motion that was found in a recording's depth (roomcast/scene_flow/scene_flow.h) is true:
// where it says that each point will be in the next frame, that frame's readings tell. Frames are
// taken to follow each other at even distances. Single-threaded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {

/// From here on a reading counts as one of another surface.
inline constexpr double kMotionOff_mm = 40;

/// Of the readings that move by more than 1.5 cm from frame to frame.
struct MotionForecast {
  std::string sensor;
  std::int64_t moving = 0;  // readings, in all frames
  /// Shares that the next frame reads elsewhere, by kMotionOff_mm and more: where the readings
  /// were, and where their motion says. Places where the next frame reads nothing do not count. 0
  /// without motion.
  double off_unmoved = 0, off_moved = 0;
};

/// `frames` of one fixed sensor, of the lens's size, in their order.
[[nodiscard]] MotionForecast forecast_motion(const std::string& sensor,
                                             const CameraIntrinsics& depth,
                                             const std::vector<DepthImage>& frames);

}  // namespace roomcast::bench
