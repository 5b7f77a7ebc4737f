// SPDX-License-Identifier: Apache-2.0
// Reads the frame sets of a rig folder or a TUM recording: groups frames by true capture time and
// resamples colour into the depth grid.
#pragma once

#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

/// kNotFound if the folder contains neither; otherwise the errors of the sources.
[[nodiscard]] Result<std::unique_ptr<FrameSetReader>> open_folder_sets(
    const std::filesystem::path& folder, nanoseconds from);

}  // namespace roomcast::recording
