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
#include "roomcast/alignment/recorded/pair_list.h"
#include "roomcast/alignment/recorded/recorded_bundles.h"

namespace roomcast::alignment {

using SharedView = std::shared_ptr<const SensorView>;

/// Errors of the bundle and of make_sensor_view.
[[nodiscard]] Result<SharedView> view_of(const RecordedBundle& recorded,
                                         const SensorViewOptions& options = {});

/// The views of all frames of a TUM recording that occur in a pair, each made once.
class FrameViews {
 public:
  /// kInvalidArgument: a name is not a frame number. Errors of read_frame_bundles.
  static Result<FrameViews> read(const std::filesystem::path& directory,
                                 const std::vector<ListedPair>& pairs, const ReadProgress& progress,
                                 const AlignmentOptions& options = {});

  /// `name` must occur in one of the pairs.
  const Result<SharedView>& at(const std::string& name);

 private:
  FrameViews(std::map<std::uint64_t, RecordedBundle> bundles, const SensorViewOptions& options);

  SensorViewOptions options_;
  std::map<std::uint64_t, RecordedBundle> bundles_;
  std::map<std::uint64_t, Result<SharedView>> views_;
};

}  // namespace roomcast::alignment
