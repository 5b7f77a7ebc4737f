// SPDX-License-Identifier: Apache-2.0
// Somebody who walks about a room for its sensors to see, as a user is told to: to every place
// where they would do something, without doing it, and turns there. Ways are those that the room
// keeps free. Metres, radians.
#pragma once

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// The first of a room's people who goes from place to place; null when nobody does.
[[nodiscard]] const Person* whoever_walks(const Room& room);

/// Nearer than that nobody has walked.
[[nodiscard]] bool is_same_place(const Eigen::Vector2f& a_m, const Eigen::Vector2f& b_m);

/// Standing there, and looking ahead.
[[nodiscard]] Waypoint standing_at(const Eigen::Vector2f& at_m, float heading_rad, float stay_s);

/// One of the room's people walks about; the others leave. False, and nothing changes, where nobody
/// walks.
[[nodiscard]] bool add_walkabout(Room& room);

}  // namespace roomcast::simulator
