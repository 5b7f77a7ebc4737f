// SPDX-License-Identifier: Apache-2.0
// Folders that only this user of the machine may enter: for secrets and the pictures of rooms.
// Threading: no state.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Creates the folder (mode 0700) and what is missing above it. An existing folder of this user is
/// closed to others if it is empty or known as ours by a file with one of these `signs` (its name
/// or extension): to close /etc would shut others out of what is theirs. Nor is a folder closed
/// that everybody may write in, as /tmp. Returns whether it had to be closed. kUnavailable: it
/// cannot be created.
[[nodiscard]] Result<bool> make_private_folder(const std::filesystem::path& folder,
                                               std::initializer_list<std::string_view> signs);

}  // namespace roomcast::io
