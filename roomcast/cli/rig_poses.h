// SPDX-License-Identifier: Apache-2.0
// Writes poses and depth scales found by alignment into the rig's rig.json. Thread-safe (no state).
#pragma once

#include <filesystem>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

/// Sets world_from_depth of every sensor of the rig, null for a sensor that was not placed, and
/// multiplies the depth scale of every placed sensor by the one that was found. Nothing else
/// changes. Without writing: kUnavailable if no sensor was placed, kInvalidArgument if a depth
/// scale would leave its range. Errors of read_rig_json and write_file.
[[nodiscard]] Status write_rig_poses(const std::filesystem::path& rig,
                                     const alignment::AlignmentReport& report);

}  // namespace roomcast::cli
