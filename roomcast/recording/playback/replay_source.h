// SPDX-License-Identifier: Apache-2.0
// A sensor of a recorded room (roomcast record) as a FrameSource: its frames decoded, colour in the
// depth grid. To be encoded anew, so that whoever joins sees it at once; `roomcast play` sends the
// recorded bytes themselves. A looping recording is played as if it had begun when the host's clock
// began, so sensors in different processes show the same instants. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

/// `sensor` by name; empty: the first. Errors as RoomRecording::open; kNotFound for a sensor that
/// sent nothing (the message lists those that did).
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_replay_source(
    const std::filesystem::path& file, const std::string& sensor, const source::PlaybackOptions& options);

/// Those that sent frames, by name. Errors as RoomRecording::open.
[[nodiscard]] Result<std::vector<std::string>> replay_sensor_names(
    const std::filesystem::path& file);

}  // namespace roomcast::recording
