// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/scene/room.h"

#include "roomcast/source/simulator/scene/livingroom.h"
#include "roomcast/source/simulator/scene/office.h"
#include "roomcast/source/simulator/scene/value_noise.h"

namespace roomcast::sim {

Result<Room> build_room(std::string_view scene, std::uint64_t seed) {
  const auto folded =
      hash_of(static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(seed));
  if (scene.empty() || scene == "livingroom") return build_livingroom(folded);
  if (scene == "office") return build_office(folded);
  return Error{ErrorCode::kNotFound, "There is no simulated scene \"" + std::string(scene) +
                                         "\"; the scenes are livingroom and office."};
}

}  // namespace roomcast::sim
