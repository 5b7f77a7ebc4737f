// SPDX-License-Identifier: Apache-2.0
// The mesh of a room in few bytes, by Google's Draco: points on a fine grid, colours in linear
// light as glTF has them, no normals. Thread-safe (no state). Sources: the Draco library;
// KHR_draco_mesh_compression of glTF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/room_mesh.h"

namespace roomcast::model {

/// Of the grid of points.
inline constexpr float kDracoStep_m = 0.002F;
/// Names of the attributes within the Draco data.
inline constexpr int kDracoPositions = 0, kDracoColors = 1;

struct DracoMesh {
  std::vector<std::uint8_t> bytes;
  std::size_t points = 0,
              triangles = 0;  // of the coded mesh: triangles without an area are left out
};

/// `mesh` has colours and at least one triangle. kInvalidArgument: it is too wide for the grid, or
/// no triangle has an area.
[[nodiscard]] Result<DracoMesh> encode_draco(const RoomMesh& mesh);

/// The mesh in `bytes`, its points in another order. kMalformed: not of encode_draco.
[[nodiscard]] Result<RoomMesh> decode_draco(std::span<const std::uint8_t> bytes);

}  // namespace roomcast::model
