// SPDX-License-Identifier: Apache-2.0
// Recordings of ScanNet (.sens, version 4): one moving camera with depth (16 bits, raw or zlib) and
// colour (JPEG, PNG or raw). Lenses are straight. The poses of the camera are not read, because
// roomcast's sensors are fixed. Layout: ScanNet's SensorData. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// kNotFound; kMalformed; kUnsupported: another version or compression; kTooLarge. Messages name
/// the file.
[[nodiscard]] Result<std::unique_ptr<SensorFile>> open_scannet_file(
    const std::filesystem::path& path);
[[nodiscard]] Result<std::unique_ptr<SensorFile>> read_scannet_file(
    std::unique_ptr<ByteSource> source, const std::string& name);

}  // namespace roomcast::recording
