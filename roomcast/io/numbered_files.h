// SPDX-License-Identifier: Apache-2.0
// Names of the files in which a viewer keeps what it shows: roomcast-ROOM-0001.png, counted up so
// that nothing is written over.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::io {

/// How a picture is written: whole or not at all.
using PictureWriter = std::function<Status(const std::filesystem::path&, ColorView)>;

/// A room's name may hold anything; a file's only letters, digits and -.
[[nodiscard]] std::string file_stem(const std::string& room);

/// The first of FOLDER/STEM-0001SUFFIX, ... that does not exist. Makes the folder. kUnavailable
/// when it cannot, or when all numbers are taken.
[[nodiscard]] Result<std::filesystem::path> next_free_path(const std::filesystem::path& folder,
                                                           const std::string& stem,
                                                           const std::string& suffix);

}  // namespace roomcast::io
