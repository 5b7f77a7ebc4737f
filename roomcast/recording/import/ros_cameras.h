// SPDX-License-Identifier: Apache-2.0
// Finds the RGB-D cameras of a ROS recording by the names and types of its topics: each depth
// stream with a camera_info beside it, and the colour stream whose topic has the longest common
// beginning with it. The transform between the two is taken from /tf_static (or /tf); where both
// are of one frame, colour is in the depth grid (same camera) or at its place. Of several depth
// streams of one camera, one that has not been resampled into the colour picture is preferred, and
// raw pictures are preferred to compressed ones. Single-threaded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/ros_store.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// kUnsupported: no depth stream with a camera_info; kMalformed. Errors do not name the file.
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> ros_sensors(
    const std::shared_ptr<RosStore>& store, const std::string& name);

}  // namespace roomcast::recording
