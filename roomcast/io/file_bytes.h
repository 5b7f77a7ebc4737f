// SPDX-License-Identifier: Apache-2.0
// Reads whole files up to a limit, and writes files completely or not at all. Every error is one
// sentence that names the file. Thread-safe (no state), except for calls on the same path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Replaces the contents of `bytes` (its memory is reused). kNotFound if the file does not exist,
/// kTooLarge above `limit_bytes`, kMalformed if it cannot be read.
[[nodiscard]] Status read_file(const std::filesystem::path& path, std::size_t limit_bytes,
                               std::vector<std::uint8_t>& bytes);

/// Writes a file next to `path` and renames it, but to a device or pipe in place, instead of
/// replacing it. kUnavailable if the disk or the permissions prevent it.
[[nodiscard]] Status write_file(const std::filesystem::path& path,
                                std::span<const std::uint8_t> bytes);
[[nodiscard]] Status write_file(const std::filesystem::path& path, std::string_view text);

/// Appends a line (given without its line end) in one write. kUnavailable as above.
[[nodiscard]] Status append_line(const std::filesystem::path& path, std::string_view line);

}  // namespace roomcast::io
