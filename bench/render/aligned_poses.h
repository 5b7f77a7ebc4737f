// SPDX-License-Identifier: Apache-2.0
// Poses that `roomcast align RIG --json` found, to draw with instead of the true ones.
#pragma once

#include <filesystem>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::bench {

/// world_from_depth of every sensor of the rig, in its order. Alignment chooses a world of its own;
/// here it is the one in which the first sensor stands where the rig says. kInvalidArgument for a
/// sensor that the file does not place; errors of read_json_object.
[[nodiscard]] Result<std::vector<RigidTransform>> read_aligned_poses(
    const std::filesystem::path& report, const recording::RigDescription& rig);

}  // namespace roomcast::bench
