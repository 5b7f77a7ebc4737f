// SPDX-License-Identifier: Apache-2.0
// Poses that alignment found, written into the rig.json they belong to. Thread-safe (no state).
#pragma once

#include <filesystem>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

/// Sets world_from_depth of every sensor of the rig: null where it was not placed. Everything else
/// stays. kUnavailable, and nothing is written, when no sensor was placed; errors of read_rig_json
/// and write_file.
[[nodiscard]] Status write_rig_poses(const std::filesystem::path& rig,
                                     const alignment::AlignmentReport& report);

}  // namespace roomcast::cli
