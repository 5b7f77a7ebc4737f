// SPDX-License-Identifier: Apache-2.0
// Reads small texts that people name on the command line: configurations, tokens, credentials.
// Also from a pipe, as `--token-file <(pass show room)`. Threading: no state.
#pragma once

#include <filesystem>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast {

/// The whole file. kNotFound: there is none, or it cannot be read, or it is a folder; kTooLarge: it
/// has more than `limit_bytes`, and no more than that are read, even of a file without an end.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path,
                                                 std::size_t limit_bytes);

}  // namespace roomcast
