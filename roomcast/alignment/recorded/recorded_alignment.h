// SPDX-License-Identifier: Apache-2.0
// Alignment of recorded sensors, as `roomcast align` does it. Single-threaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomcast/alignment/alignment_options.h"
#include "roomcast/alignment/recorded/recorded_bundles.h"
#include "roomcast/alignment/recorded/recorded_views.h"
#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::alignment {

/// `method` is "auto", or "homography" (the baseline).
[[nodiscard]] AlignmentReport align_views(const std::vector<SharedView>& views,
                                          const std::string& method,
                                          const AlignmentOptions& options,
                                          const AlignProgress& progress,
                                          DepthScaling scaling = DepthScaling::kAsCalibrated);

/// Aligns the sensors of a rig folder, with factors on their readings where `scaling` allows that
/// and they are determined. A sensor without a usable bundle is in the report, with the reason.
/// Errors of read_rig_bundles.
[[nodiscard]] Result<AlignmentReport> align_recording(
    const std::filesystem::path& rig, const std::string& method, const AlignmentOptions& options,
    const ReadProgress& progress, DepthScaling scaling = DepthScaling::kAsCalibrated);

}  // namespace roomcast::alignment
