// SPDX-License-Identifier: Apache-2.0
// The depth that one sensor of a rig has recorded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {

struct RigDepth {
  CameraIntrinsics lens;
  std::vector<DepthImage> frames;  // in their order; at least one
};

/// Reads up to 64 frames of sensor `id` of a rig. Errors of its files; kInvalidArgument without a
/// frame.
[[nodiscard]] Result<RigDepth> read_rig_depth(const std::filesystem::path& rig,
                                              const std::string& id);

}  // namespace roomcast::bench
