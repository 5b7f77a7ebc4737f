// SPDX-License-Identifier: Apache-2.0
// Sensor mounts for a room of a given size, slightly different for every seed. Metres.
#pragma once

#include <array>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

inline constexpr int kTripods = 4;

using Stands = std::array<SensorMount, kMaxSimulatedSensors>;

/// In corners and at walls in turn, at different heights, all facing the room's centre.
[[nodiscard]] Stands draw_sensor_mounts_around(const Eigen::Vector3f& room_size_m, Random& random);

/// The first four in the four corners, 1.9 to 2.1 m high: the first and third face each other, as
/// do the second and fourth. The others at the walls.
[[nodiscard]] Stands draw_sensor_mounts_in_corners(const Eigen::Vector3f& room_size_m,
                                                   Random& random);

/// The first kTripods on tripods about 2.2 m from the room's centre, at chest or head height, 90
/// degrees apart; the others at the walls.
[[nodiscard]] Stands draw_sensor_mounts_on_tripods(const Eigen::Vector3f& room_size_m,
                                                   Random& random);

}  // namespace roomcast::simulator
