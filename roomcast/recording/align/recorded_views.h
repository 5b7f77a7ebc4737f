// SPDX-License-Identifier: Apache-2.0
// Views of recorded sensors, as input for alignment. Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/alignment/alignment_options.h"
#include "roomcast/recording/align/pair_list.h"
#include "roomcast/recording/align/recorded_bundles.h"

namespace roomcast::recording {

using SharedView = std::shared_ptr<const alignment::SensorView>;

/// Errors of the bundle and of alignment::make_sensor_view.
[[nodiscard]] Result<SharedView> view_of(const RecordedBundle& recorded,
                                         const alignment::SensorViewOptions& options = {});

/// The views of all frames of a TUM recording that occur in a pair, each made once.
class FrameViews {
 public:
  /// kInvalidArgument: a name is not a frame number. Errors of read_frame_bundles.
  static Result<FrameViews> read(const std::filesystem::path& directory,
                                 const std::vector<ListedPair>& pairs, const ReadProgress& progress,
                                 const alignment::AlignmentOptions& options = {});

  /// `name` must occur in one of the pairs.
  const Result<SharedView>& at(const std::string& name);

 private:
  FrameViews(std::map<std::uint64_t, RecordedBundle> bundles,
             const alignment::SensorViewOptions& options);

  alignment::SensorViewOptions options_;
  std::map<std::uint64_t, RecordedBundle> bundles_;
  std::map<std::uint64_t, Result<SharedView>> views_;
};

}  // namespace roomcast::recording
