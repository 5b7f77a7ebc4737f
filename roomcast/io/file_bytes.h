// SPDX-License-Identifier: Apache-2.0
// Whole files: read with a limit, written so that they are there completely or not at all.
// Every error is one sentence that names the file. Thread-safe (no state), except on one and the
// same path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Replaces the contents of `bytes` (its memory is used again). kNotFound when there is no such
/// file, kTooLarge above `limit_bytes`, kMalformed when it cannot be read.
[[nodiscard]] Status read_file(const std::filesystem::path& path, std::size_t limit_bytes,
                               std::vector<std::uint8_t>& bytes);

/// Writes beside `path` and renames. kUnavailable when the disk or the permissions do not allow it.
[[nodiscard]] Status write_file(const std::filesystem::path& path,
                                std::span<const std::uint8_t> bytes);
[[nodiscard]] Status write_file(const std::filesystem::path& path, std::string_view text);

/// Adds a line (given without its end) in one write. kUnavailable as above.
[[nodiscard]] Status append_line(const std::filesystem::path& path, std::string_view line);

}  // namespace roomcast::io
