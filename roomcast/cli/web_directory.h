// SPDX-License-Identifier: Apache-2.0
// Where the built page is: named by the user, beside the build, or installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace roomcast::cli {

/// `named` if not empty; else $ROOMCAST_WEB; else the first of <program>/../../web (a build tree)
/// and <program>/../share/roomcast/web (installed) that holds an index.html; else nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_web_directory(const std::string& named);

}  // namespace roomcast::cli
