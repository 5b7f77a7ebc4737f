// SPDX-License-Identifier: Apache-2.0
// Names for files saved by a viewer: roomcast-ROOM-0001.png, numbered so that no file is
// overwritten.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::io {

/// Writes a picture completely or not at all.
using PictureWriter = std::function<Status(const std::filesystem::path&, ColorView)>;

/// File stem for a room. A room's name may contain any character; the stem contains only letters,
/// digits and -.
[[nodiscard]] std::string file_stem(const std::string& room);

/// The first of FOLDER/STEM-0001SUFFIX, ... that does not exist. Creates the folder. kUnavailable
/// if that fails, or if all numbers are taken.
[[nodiscard]] Result<std::filesystem::path> next_free_path(const std::filesystem::path& folder,
                                                           const std::string& stem,
                                                           const std::string& suffix);

}  // namespace roomcast::io
