// SPDX-License-Identifier: Apache-2.0
// Gathers the static part of a recorded room: for each sensor the median of its depth over many
// frames. Measurements use these pictures instead of single noisy frames. Metres, pictures in
// millimetres; world frame.
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
  double expected_error_m = 0;  // of the pose, 2.5 m in front of it; 0 if the pose was given
  DepthImage depth_mm;
  std::size_t frame_count = 0;  // frames in the median
  double scale_error = 0;       // of the room, as SetSensor::scale_error
};

/// More frames do not improve the median noticeably.
inline constexpr std::size_t kMaxStaticFrames = 30;

/// Reads up to kMaxStaticFrames sets, evenly spaced if the reader knows its length. Unplaced
/// sensors are left out, unless there is only one sensor, whose frame is then the world frame.
/// `progress` (may be empty) is called after each set. kNotFound if there is nothing to measure;
/// kMalformed if the recording is damaged from its beginning.
[[nodiscard]] Result<std::vector<StaticSensor>> gather_static_room(
    FrameSetReader& reader, const std::function<void(std::size_t sets)>& progress = {});

}  // namespace roomcast::recording
