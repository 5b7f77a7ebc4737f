// SPDX-License-Identifier: Apache-2.0
// Adds a person who walks through a room in view of its sensors, as users are asked to: to every
// place at which the room's own people have an activity, without performing it, and turns there.
// Paths are those that the room keeps free. Metres, radians.
#pragma once

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// The first of a room's people who walks between places; null if there is none.
[[nodiscard]] const Person* whoever_walks(const Room& room);

/// True if two places are too close to count as different ones.
[[nodiscard]] bool is_same_place(const Eigen::Vector2f& a_m, const Eigen::Vector2f& b_m);

/// A waypoint of standing there, looking ahead.
[[nodiscard]] Waypoint standing_at(const Eigen::Vector2f& at_m, float heading_rad, float stay_s);

/// One of the room's people walks about; the others are removed. Returns false without changes if
/// no person walks.
[[nodiscard]] bool add_walkabout(Room& room);

}  // namespace roomcast::simulator
