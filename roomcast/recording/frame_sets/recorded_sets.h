// SPDX-License-Identifier: Apache-2.0
// Reads the frame sets of a file of `roomcast record`, as the hub sent them.
#pragma once

#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

/// Errors as RoomRecording::open.
[[nodiscard]] Result<std::unique_ptr<FrameSetReader>> open_recorded_sets(
    const std::filesystem::path& file, nanoseconds from);

}  // namespace roomcast::recording
