// SPDX-License-Identifier: Apache-2.0
// Recordings of Record3D (.r3d): one iPhone or iPad with LiDAR or TrueDepth. A ZIP file of
//   metadata                    JSON: w, h of colour; dw, dh of depth; K, its columns one after the
//                               other; fps; frameTimestamps in seconds
//   rgbd/N.jpg, rgbd/N.depth    of each frame; depth in metres as floats, LZFSE
// Both pictures are of one camera; K is colour's, and scaled for depth. Not read: poses (roomcast's
// sensors are fixed), changes of K while the lens focuses, confidence. The format is as
// github.com/marek-simonik/record3d and the programs that read it show it. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// kNotFound; kMalformed; kUnsupported; kTooLarge. Messages name the file.
[[nodiscard]] Result<std::unique_ptr<SensorFile>> open_record3d_file(
    const std::filesystem::path& path);
[[nodiscard]] Result<std::unique_ptr<SensorFile>> read_record3d_file(
    std::unique_ptr<ByteSource> source, const std::string& name);

}  // namespace roomcast::recording
