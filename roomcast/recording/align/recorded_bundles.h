// SPDX-License-Identifier: Apache-2.0
// Calibration bundles made from recordings: as the sensors of a rig would send them when joining,
// or one per frame of a TUM recording, as if each frame were a sensor. Single-threaded.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/core/result.h"

namespace roomcast::recording {

/// A sensor with its bundle, or the reason why it has none.
struct RecordedBundle {
  std::string name;
  Result<alignment::CalibrationBundle> bundle;
};

/// Called with a description of what is being read.
using ReadProgress = std::function<void(const std::string& what)>;

/// One bundle for each sensor of the rig, in the rig's order, from the sensor's first second.
/// Errors of the recording's files.
[[nodiscard]] Result<std::vector<RecordedBundle>> read_rig_bundles(
    const std::filesystem::path& directory, const ReadProgress& progress,
    const alignment::BundleCaptureOptions& options = {});

/// Bundles of the frames with these numbers, by number. kNotFound, naming the frame: it does not
/// exist. Errors of the recording's files.
[[nodiscard]] Result<std::map<std::uint64_t, RecordedBundle>> read_frame_bundles(
    const std::filesystem::path& directory, const std::set<std::uint64_t>& frames,
    const ReadProgress& progress, const alignment::BundleCaptureOptions& options = {});

}  // namespace roomcast::recording
