// SPDX-License-Identifier: Apache-2.0
// A folder of pictures with a recording.toml that says what is what: for each sensor its name, the
// folders of its depth (16-bit grey PNG) and colour (JPEG or PNG), their cameras, and the times.
// The fields are described in docs/spec/rig.md. Pictures are taken in the order of their names; the
// n-th colour belongs to the n-th depth. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

inline constexpr const char* kPictureFolderFile = "recording.toml";

/// `path`: the folder, or its recording.toml. kNotFound: it is missing, or a folder without
/// pictures; kMalformed with file and field; kTooLarge.
[[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> open_picture_folder(
    const std::filesystem::path& path);

}  // namespace roomcast::recording
