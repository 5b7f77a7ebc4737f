// SPDX-License-Identifier: Apache-2.0
// The views of a running room on disk, as a rig folder of one frame for each sensor: every program
// that reads rigs can look at it. Thread-safe (no state), except for calls on the same folder.
#pragma once

#include <filesystem>

#include "roomcast/core/result.h"
#include "roomcast/recording/modeler/kept_views.h"

namespace roomcast::recording {

/// Replaces what was there. Without views nothing is left. kUnavailable: the disk refuses.
[[nodiscard]] Status write_views(const std::filesystem::path& folder,
                                 const KeptViews::Saved& views);

/// kNotFound: there is no such folder. Errors of FrameSetReader.
[[nodiscard]] Result<KeptViews::Saved> read_views(const std::filesystem::path& folder);

}  // namespace roomcast::recording
