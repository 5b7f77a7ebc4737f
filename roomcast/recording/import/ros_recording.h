// SPDX-License-Identifier: Apache-2.0
// Opens ROS recordings: bags of ROS 1, also those of RealSense cameras, and
// MCAP files and SQLite databases of ROS 2. Single-threaded; the
// sensors of one recording are used by one thread.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// kNotFound; kMalformed, kUnsupported, kTooLarge. Messages name the file.
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> open_ros1_bag(
    const std::filesystem::path& path);

/// The same for an MCAP file or SQLite database, by its content, or the folder of one (rosbag2).
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> open_ros2_recording(
    const std::filesystem::path& path);

}  // namespace roomcast::recording
