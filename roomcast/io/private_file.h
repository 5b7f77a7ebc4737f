// SPDX-License-Identifier: Apache-2.0
// Files that only this user of the machine may read: tokens. Threading: no state.
#pragma once

#include <filesystem>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Creates the file (mode 0600, whatever the umask) with this text. kUnavailable: it exists, so
/// that nothing is overwritten and no one who has it open reads on, or it cannot be written; then
/// nothing is left behind.
[[nodiscard]] Status write_private_file(const std::filesystem::path& file, std::string_view text);

}  // namespace roomcast::io
