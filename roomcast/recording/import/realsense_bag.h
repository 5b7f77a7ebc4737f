// SPDX-License-Identifier: Apache-2.0
// The layout of RealSense recordings (rs-record, RealSense Viewer) in ROS 1 bags:
//   /device_0/info                                   KeyValue: "Serial Number"
//   /device_0/sensor_0/option/Depth Units/value      Float32, metres
//   /device_0/sensor_0/Depth_0/info/camera_info      CameraInfo
//   /device_0/sensor_0/Depth_0/image/data            Image: depth is mono16
//   /device_0/sensor_0/Depth_0/image/metadata        KeyValue: "system_time", "timestamp_domain"
//   /device_0/sensor_0/Depth_0/tf/0                  Transform: this camera from the first one
// and so for Color_0. Infrared and motion are not read. Source: librealsense,
// src/media/ros/ros_file_format.h. Single-threaded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/ros_store.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// Whether the recording has that layout.
[[nodiscard]] bool is_realsense(const RosStore& store);

/// A sensor for each device with depth. kMalformed, kUnsupported; errors do not name the file.
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> realsense_sensors(
    const std::shared_ptr<RosStore>& store, const std::string& name);

}  // namespace roomcast::recording
