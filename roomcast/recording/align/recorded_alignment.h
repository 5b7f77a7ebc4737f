// SPDX-License-Identifier: Apache-2.0
// Alignment of recorded sensors, as `roomcast align` does it. Single-threaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomcast/alignment/alignment_options.h"
#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/rig/rig_aligner.h"
#include "roomcast/recording/align/recorded_bundles.h"
#include "roomcast/recording/align/recorded_views.h"

namespace roomcast::recording {

/// `method` is "auto", or "homography" (the baseline).
[[nodiscard]] alignment::AlignmentReport align_views(
    const std::vector<SharedView>& views, const std::string& method,
    const alignment::AlignmentOptions& options, const alignment::AlignProgress& progress,
    alignment::DepthScaling scaling = alignment::DepthScaling::kAsCalibrated);

/// Aligns the sensors of a rig folder, with factors on their readings where `scaling` allows that
/// and they are determined. A sensor without a usable bundle is in the report, with the reason.
/// Errors of read_rig_bundles.
[[nodiscard]] Result<alignment::AlignmentReport> align_recording(
    const std::filesystem::path& rig, const std::string& method,
    const alignment::AlignmentOptions& options, const ReadProgress& progress,
    alignment::DepthScaling scaling = alignment::DepthScaling::kAsCalibrated);

}  // namespace roomcast::recording
