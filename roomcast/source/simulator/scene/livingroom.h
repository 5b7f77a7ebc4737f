// SPDX-License-Identifier: Apache-2.0
// A living room: sofa, table and chairs, shelf, plant, lamp, window, pictures. The seed varies its
// things.
#pragma once

#include <cstdint>

#include "roomcast/source/simulator/scene/room.h"

namespace roomcast::sim {

[[nodiscard]] Room build_livingroom(std::uint32_t seed);

}  // namespace roomcast::sim
