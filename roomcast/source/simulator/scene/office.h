// SPDX-License-Identifier: Apache-2.0
// An office: desks with monitors, chairs, shelves, a sideboard, a plant. The seed varies its
// things.
#pragma once

#include <cstdint>

#include "roomcast/source/simulator/scene/room.h"

namespace roomcast::sim {

[[nodiscard]] Room build_office(std::uint32_t seed);

}  // namespace roomcast::sim
