// SPDX-License-Identifier: Apache-2.0
// The true views of a rig, as drawn views are judged by them.
#pragma once

#include <vector>

#include "bench/render/rig_frames.h"
#include "bench/render/truth_view.h"
#include "bench/render/view_classes.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

struct JudgedView {
  TruthViewEntry entry;
  TruthView truth;
  ViewClasses classes;
};

/// Reads the noise-free depth of all frames, one at a time. Errors of the files.
[[nodiscard]] Result<std::vector<JudgedView>> read_judged_views(
    const std::vector<TruthViewEntry>& entries, RigFrames& frames);

}  // namespace roomcast::bench
