// SPDX-License-Identifier: Apache-2.0
// Finds the folder of the built page: given by the user, in the build tree, or installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace roomcast::cli {

/// Returns `named` if it is not empty; else $ROOMCAST_WEB; else the first of <program>/../../web (a
/// build tree) and <program>/../share/roomcast/web (installed) that contains an index.html; else
/// nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_web_directory(const std::string& named);

}  // namespace roomcast::cli
