// SPDX-License-Identifier: Apache-2.0
// What stands still in a recorded room: for each sensor the median of its depth over many frames.
// Measured in are these, not single noisy frames. Metres, millimetres in pictures; world frame.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

struct StaticSensor {
  std::string name;
  CameraIntrinsics depth;
  RigidTransform world_from_depth;
  double expected_error_m = 0;  // of that place, 2.5 m in front of it; 0 where it was given
  DepthImage depth_mm;
  std::size_t frame_count = 0;  // of which that is the median
};

/// More frames than this say nothing new.
inline constexpr std::size_t kMaxStaticFrames = 30;

/// Reads up to kMaxStaticFrames sets, evenly spread as far as the reader knows its length. Sensors
/// that nobody has placed are left out, unless there is but one, which then is the world's origin.
/// `progress` (may be empty) after each set. kNotFound when nothing can be measured in; kMalformed
/// when the recording is damaged from its beginning.
[[nodiscard]] Result<std::vector<StaticSensor>> gather_static_room(
    FrameSetReader& reader, const std::function<void(std::size_t sets)>& progress = {});

}  // namespace roomcast::recording
