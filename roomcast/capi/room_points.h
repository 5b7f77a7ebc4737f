// SPDX-License-Identifier: Apache-2.0
// Converts the frames of a room's sensors to points for libroomcast. World frame, metres.
// Threading: no state.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/capi/received_sensor.h"
#include "roomcast/capi/roomcast.h"

namespace roomcast::capi {

/// Writes one point for each depth reading of each placed sensor, up to the size of `out`; grey
/// where a sensor has no colour. Returns the number of points there are, which may be more.
std::size_t write_points(const std::vector<ReceivedSensor>& sensors, std::span<roomcast_point> out);

}  // namespace roomcast::capi
