// SPDX-License-Identifier: Apache-2.0
// From a SPEC on the command line to a FrameSource:  sim[:scene][#sensor]  rig:DIR#s0  tum:DIR
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast {

struct SourceOptions {
  Pace pace = Pace::kRealTime;
  bool loop = true;            // recordings start again at their end
  double sim_fps = 15;         // sim: frames per second
  int sim_sensor_count = 3;    // sim: how many sensors stand around the room
  std::uint64_t sim_seed = 1;  // sim: noise and furniture
};

/// kInvalidArgument for a SPEC that names no kind we have (the message lists them); else the kind's
/// own errors.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> open_source(const std::string& spec,
                                                               const SourceOptions& options = {});

/// The sensors of a rig folder, in its order: "s0", "s1"...
[[nodiscard]] Result<std::vector<std::string>> rig_sensor_names(const std::string& directory);

}  // namespace roomcast
