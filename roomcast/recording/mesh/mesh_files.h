// SPDX-License-Identifier: Apache-2.0
// Encodes the mesh of a room, with normals and the colours of its points:
//   GLB  glTF 2.0 binary, one unlit mesh; colours in linear light, as glTF has them
//   draco.glb  the same without normals, in a tenth of the bytes (draco_mesh.h); readers need the
//        extension KHR_draco_mesh_compression
//   PLY  binary little-endian 1.0: x y z nx ny nz (float), red green blue (uchar), triangles
//   OBJ  text; the colours follow the coordinates of a point, as most programs read them
// Metres, y up. Thread-safe (no state).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/room_mesh.h"

namespace roomcast::recording {

enum class MeshFile { kGlb, kDracoGlb, kPly, kObj };
inline constexpr std::array kMeshFiles = {MeshFile::kGlb, MeshFile::kDracoGlb, MeshFile::kPly,
                                          MeshFile::kObj};
[[nodiscard]] std::string_view ending_of(MeshFile file);

/// `mesh` has colours and at least one triangle. Errors: those of encode_draco.
[[nodiscard]] Status append_mesh(const model::RoomMesh& mesh, MeshFile file,
                                 std::vector<std::uint8_t>& out);

}  // namespace roomcast::recording
