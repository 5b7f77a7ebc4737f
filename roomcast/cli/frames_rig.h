// SPDX-License-Identifier: Apache-2.0
// A recorded rig for `roomcast bench align --suite frames`: its sensors, their true poses, the ball
// of ball.json, and bundles of any window of frames, read when they are needed. Single-threaded.
#pragma once

#include <filesystem>

#include "bench/align/frames_suite.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

inline constexpr std::size_t kMaxBallSightings = 100'000;

/// ball.json is optional:
///   {"ball": [{"sensor": "s0", "frame": 0, "center_in_depth_camera_mm": [x, y, z]}, ...]}
/// Errors of the recording's files; kMalformed for a ball.json of another form.
[[nodiscard]] Result<bench::FramesRig> read_frames_rig(const std::filesystem::path& directory);

}  // namespace roomcast::cli
