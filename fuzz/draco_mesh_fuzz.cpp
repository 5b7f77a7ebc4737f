// SPDX-License-Identifier: Apache-2.0
// Decodes an untrusted piece of a room's model: any bytes are refused or give a mesh whose
// triangles have the points that they name.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "roomcast/model/pieces/draco_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto mesh = roomcast::model::decode_draco({data, size});
  if (!mesh) return 0;
  if (mesh->colors.size() != mesh->points_m.size()) __builtin_trap();
  for (const auto& point_m : mesh->points_m) {
    if (!point_m.allFinite()) __builtin_trap();
  }
  for (const auto& triangle : mesh->triangles) {
    if (*std::ranges::max_element(triangle) >= mesh->points_m.size()) __builtin_trap();
  }
  return 0;
}
