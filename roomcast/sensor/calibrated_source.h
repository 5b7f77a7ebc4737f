// SPDX-License-Identifier: Apache-2.0
// A source whose cameras are known better than it says itself: its frames with the calibration of a
// camera.json, as `roomcast calibrate` writes it, and depth put right. Threading as the source's.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::sensor {

/// Errors of read_camera_json. kInvalidArgument: the file is about pictures of other sizes than
/// this source gives, or lacks the colour camera that it has.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> with_calibration(
    std::unique_ptr<source::FrameSource> source, const std::filesystem::path& camera_json);

}  // namespace roomcast::sensor
