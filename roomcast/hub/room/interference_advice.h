// SPDX-License-Identifier: Apache-2.0
// Advice about sensors that disturb each other with their infrared light. A sensor reports how
// much it is disturbed, but not by whom; the neighbour to blame is the sensor that lights the
// largest part of its view, by the poses and lenses that the room knows. Pure functions.
#pragma once

#include <optional>

#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/room/sensor_list.h"

namespace roomcast::hub {

/// Figures from which a sensor counts as disturbed.
inline constexpr double kDisturbedFlickering = 0.005, kDisturbedNoiseRatio = 1.5;

/// The share, 0 to 1, of what a sensor sees within 1 to 4 m that another one sees, too, from at
/// most 6 m away. Distortion of the lenses and what hides surfaces are left out.
[[nodiscard]] double shared_view(const RoomSensor& sensor, const RoomSensor& other);

/// Nothing while the sensor is offline or has reported nothing.
[[nodiscard]] std::optional<SensorInterference> interference_of(const RoomSensor& sensor,
                                                                const SensorList& all);

}  // namespace roomcast::hub
