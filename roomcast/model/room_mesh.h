// SPDX-License-Identifier: Apache-2.0
// RoomMesh: the surface of a room as triangles with colours. Metres, world frame. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"

namespace roomcast::model {

struct RoomMesh {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<Rgb8> colors;                             // of the points; may be empty
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise as seen from the room
};

/// Unit normals of the points: of the triangles around them, by area.
[[nodiscard]] std::vector<Eigen::Vector3f> point_normals(const RoomMesh& mesh);

/// Removes triangles that hang together with fewer than `min_triangles` in all, and points that no
/// triangle uses.
void remove_small_parts(int min_triangles, RoomMesh& mesh);

}  // namespace roomcast::model
