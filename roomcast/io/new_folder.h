// SPDX-License-Identifier: Apache-2.0
// Makes folders to write into. Every error is one sentence that names the folder. Thread-safe (no
// state).
#pragma once

#include <filesystem>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Creates the folder and what is missing above it; an existing one is left as it is. kUnavailable:
/// it cannot be created.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

/// The same, but kUnavailable if there is anything of this name, so that nothing is overwritten.
[[nodiscard]] Status make_new_folder(const std::filesystem::path& folder);

}  // namespace roomcast::io
