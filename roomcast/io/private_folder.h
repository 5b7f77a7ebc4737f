// SPDX-License-Identifier: Apache-2.0
// Folders that only this user of the machine may enter: for secrets and the pictures of rooms.
// Threading: no state.
#pragma once

#include <filesystem>

#include "roomcast/core/result.h"

namespace roomcast::io {

/// Creates the folder (mode 0700) and what is missing above it. An existing folder of this user is
/// closed to others, unless everybody may write in it, as in /tmp: that is no folder of ours.
/// Returns whether it had to be closed. kUnavailable: it cannot be created.
[[nodiscard]] Result<bool> make_private_folder(const std::filesystem::path& folder);

}  // namespace roomcast::io
