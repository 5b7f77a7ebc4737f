// SPDX-License-Identifier: Apache-2.0
// The surface of a fused volume as triangles, by marching cubes (cube_cases.h), and its colours
// from the views that see it best. Metres, world frame. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/parallel_rows.h"
#include "roomcast/model/model_options.h"
#include "roomcast/model/room_mesh.h"
#include "roomcast/model/room_volume.h"

namespace roomcast::model {

/// Without colours. Points where blocks meet are one point, so the surface has no cracks.
[[nodiscard]] RoomMesh mesh_volume(const RoomVolume& volume);

/// Of points whose colour no view has.
inline constexpr Rgb8 kNoColor{128, 128, 128};

/// Colours every point by the views in which it is visible, nearly only by those that see it from
/// nearby and from the front; kNoColor where no view has its colour. `gains`: of each view
/// (color_gains.h).
void color_mesh(std::span<const ViewSurface> views, std::span<const Eigen::Vector3f> gains,
                const ModelOptions& options, const Workers& workers, RoomMesh& mesh);

/// Removes triangles that have a point of the colour kNoColor.
void remove_uncolored(RoomMesh& mesh);

}  // namespace roomcast::model
