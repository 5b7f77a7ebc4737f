// SPDX-License-Identifier: Apache-2.0
// Writes poses found by alignment into the rig's rig.json. Thread-safe (no state).
#pragma once

#include <filesystem>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

/// Sets world_from_depth of every sensor of the rig, null for a sensor that was not placed. Nothing
/// else changes. kUnavailable, without writing: no sensor was placed. Errors of read_rig_json and
/// write_file.
[[nodiscard]] Status write_rig_poses(const std::filesystem::path& rig,
                                     const alignment::AlignmentReport& report);

}  // namespace roomcast::cli
