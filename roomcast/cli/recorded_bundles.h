// SPDX-License-Identifier: Apache-2.0
// Calibration bundles from recordings: what the sensors of a rig would have sent on joining, and
// single frames of a TUM recording as if each were a sensor of its own. Single-threaded.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

/// A sensor whose bundle may not be of any use: then why.
struct RecordedBundle {
  std::string name;
  Result<alignment::CalibrationBundle> bundle;
};

/// Told what is being read.
using ReadProgress = std::function<void(const std::string& what)>;

/// One for each sensor of the rig, in its order, from its first second. Errors of the recording's
/// files.
[[nodiscard]] Result<std::vector<RecordedBundle>> read_rig_bundles(
    const std::filesystem::path& directory, const ReadProgress& progress);

/// Of the frames with these numbers, by number. kNotFound, naming it, for a frame that is not
/// there; errors of the recording's files.
[[nodiscard]] Result<std::map<std::uint64_t, RecordedBundle>> read_frame_bundles(
    const std::filesystem::path& directory, const std::set<std::uint64_t>& frames,
    const ReadProgress& progress);

}  // namespace roomcast::cli
