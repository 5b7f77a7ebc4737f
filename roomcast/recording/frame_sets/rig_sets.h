// SPDX-License-Identifier: Apache-2.0
// The frame sets of a rig folder or a TUM recording: frames of the same instant by true time,
// colour resampled into the depth grid.
#pragma once

#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

/// kNotFound where the folder holds neither; errors of the sources.
[[nodiscard]] Result<std::unique_ptr<FrameSetReader>> open_folder_sets(
    const std::filesystem::path& folder, nanoseconds from);

}  // namespace roomcast::recording
