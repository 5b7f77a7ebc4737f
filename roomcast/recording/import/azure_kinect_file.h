// SPDX-License-Identifier: Apache-2.0
// A recording of k4arecorder: a Matroska file with the tracks COLOR (MJPEG, NV12, YUY2 or BGRA),
// DEPTH and IR (16 bit, big-endian), tags with the camera's settings, and calibration.json. IR and
// motion are not read. Device time is the camera's own: that of the file plus its start offset.
// Format: Azure Kinect documentation, "record file format". Single-threaded.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// kNotFound; kMalformed: damaged before the first picture; kUnsupported: not of an Azure Kinect,
/// without depth, or with another lens model; kTooLarge. Messages name the file.
[[nodiscard]] Result<std::unique_ptr<SensorFile>> open_azure_kinect_file(
    const std::filesystem::path& path);
/// `name` is that of the file, for messages and, without a serial number, for the sensor.
[[nodiscard]] Result<std::unique_ptr<SensorFile>> read_azure_kinect_file(
    std::unique_ptr<ByteSource> source, const std::string& name);

}  // namespace roomcast::recording
