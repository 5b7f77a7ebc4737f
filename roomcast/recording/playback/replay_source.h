// SPDX-License-Identifier: Apache-2.0
// Opens a sensor of a recorded room (roomcast record) as a FrameSource with decoded frames, colour
// in the depth grid. The frames are meant to be encoded again, so that a viewer that joins gets a
// key frame at once; `roomcast play` sends the recorded bytes themselves. A looping recording is
// played as if it had begun when the host's clock began, so sensors in different processes show the
// same instants. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

/// `sensor`: name; empty: the first one. Errors as RoomRecording::open; kNotFound for a sensor that
/// sent no frames (the message lists those that did).
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_replay_source(
    const std::filesystem::path& file, const std::string& sensor,
    const source::PlaybackOptions& options);

/// Names of the sensors that sent frames, sorted. Errors as RoomRecording::open.
[[nodiscard]] Result<std::vector<std::string>> replay_sensor_names(
    const std::filesystem::path& file);

}  // namespace roomcast::recording
