// SPDX-License-Identifier: Apache-2.0
// Opens MCAP files of Foxglove's schemas in Protobuf, as `roomcast export --format foxglove` and
// Foxglove itself write them. A sensor is a topic of depth pictures (RawImage, or CompressedImage
// in PNG of 16 bits) with a CameraCalibration of its frame. Its colour (RawImage, CompressedImage
// in JPEG or PNG, CompressedVideo in VP9) is that of the topic with the longest common beginning,
// in the same frame or joined to it by FrameTransforms. A sensor is placed where transforms lead to
// a root frame, the world: z points up in it, unless the channel of the transforms says "up": "y"
// as roomcast's own files can. Single-threaded; the sensors of one recording are used by one
// thread.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// Whether it is an MCAP file with such messages.
[[nodiscard]] bool is_foxglove_recording(const std::filesystem::path& path);

/// kNotFound; kMalformed, kUnsupported, kTooLarge. Messages name the file.
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> open_foxglove_recording(
    const std::filesystem::path& path);

}  // namespace roomcast::recording
