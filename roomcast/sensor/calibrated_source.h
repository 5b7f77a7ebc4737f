// SPDX-License-Identifier: Apache-2.0
// Wraps a source: replaces its calibration by that of a camera.json, as written by `roomcast
// calibrate`, and corrects its depth. Threading as the source's.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::sensor {

/// Errors of read_camera_json. kInvalidArgument: the file is for pictures of other sizes than this
/// source's, or lacks the colour camera that the source has.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> with_calibration(
    std::unique_ptr<source::FrameSource> source, const std::filesystem::path& camera_json);

}  // namespace roomcast::sensor
