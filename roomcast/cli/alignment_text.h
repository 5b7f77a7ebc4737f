// SPDX-License-Identifier: Apache-2.0
// Formats an alignment report as JSON for scripts and as a table for people. Thread-safe (no
// state).
#pragma once

#include <string>

#include "roomcast/alignment/alignment_options.h"
#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::cli {

/// {"sensors": [{"id", "placed", "world_from_depth", "expected_error_mm", "expected_error_deg",
/// "color_shift_px", "overlap", "inliers", "residual_mm", "reason"}],
///   "pairs": [{"a", "b", "accepted", "b_from_a", "overlap", "inliers", "residual_mm",
///   "expected_error_mm", "conflict", "correlation", "margin", "reason"}]}; transforms row-major;
/// values that need a pose are null where there is none.
[[nodiscard]] std::string alignment_json(const alignment::AlignmentReport& report);

/// The same with "options": stage -> field -> value, as alignment_options.h names them.
[[nodiscard]] std::string alignment_json(const alignment::AlignmentReport& report,
                                         const alignment::AlignmentOptions& options);

[[nodiscard]] std::string alignment_table(const alignment::AlignmentReport& report);

}  // namespace roomcast::cli
