// SPDX-License-Identifier: Apache-2.0
// The points of a room's sensors as libroomcast hands them out. World frame, metres. Threading: no
// state.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/capi/received_sensor.h"
#include "roomcast/capi/roomcast.h"

namespace roomcast::capi {

/// Writes a point for every reading of every sensor that has been placed, as many as `out` has room
/// for; grey where a sensor has no colour. Returns how many there are.
std::size_t write_points(const std::vector<ReceivedSensor>& sensors, std::span<roomcast_point> out);

}  // namespace roomcast::capi
