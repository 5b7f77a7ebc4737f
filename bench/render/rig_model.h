// SPDX-License-Identifier: Apache-2.0
// The model of what stands still in a rig, as a hub keeps it of a running room: cells of 2 cm, and
// what the sensors' frames show, with the given poses.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bench/render/rig_frames.h"
#include "roomcast/model/room_mesh.h"

namespace roomcast::bench {

/// `poses`: world_from_depth of each sensor. Leaves out the frames of which `is_left_out` says so.
/// Errors of the files and of mesh_surfaces.
[[nodiscard]] Result<model::RoomMesh> fuse_rig(
    RigFrames& frames, std::span<const RigidTransform> poses,
    const std::function<bool(std::size_t sensor, std::uint64_t number)>& is_left_out);

}  // namespace roomcast::bench
