// SPDX-License-Identifier: Apache-2.0
// Reads poses estimated by `roomcast align RIG --json`, to draw with them instead of the true
// poses.
#pragma once

#include <filesystem>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::bench {

/// world_from_depth of every sensor of the rig, in the rig's order. Alignment chooses its own world
/// frame; the result is in the world in which the first sensor has its pose from the rig.
/// kInvalidArgument: the file does not place a sensor. Errors of read_json_object.
[[nodiscard]] Result<std::vector<RigidTransform>> read_aligned_poses(
    const std::filesystem::path& report, const recording::RigDescription& rig);

}  // namespace roomcast::bench
