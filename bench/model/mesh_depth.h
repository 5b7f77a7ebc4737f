// SPDX-License-Identifier: Apache-2.0
// The depth that a camera would see of a mesh. Triangles that face away are not drawn. Metres, 0
// for nothing. Thread-safe (no state).
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/model/room_mesh.h"

namespace roomcast::bench {

[[nodiscard]] Image<float> mesh_depth_m(const model::RoomMesh& mesh, const CameraIntrinsics& camera,
                                        const RigidTransform& world_from_camera);

}  // namespace roomcast::bench
