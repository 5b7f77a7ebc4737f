// SPDX-License-Identifier: Apache-2.0
// The condition of one sensor of a recording, learnt from its frames alone: its noise by distance,
// and how much the infrared light of other sensors disturbs it, before and after the sensor's own
// filter (roomcast/sensor/interference_filter.h). The recording is played forward and backward at
// 30 frames/s, because those of rigs last a second or so. Single-threaded.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/sensor/interference_meter.h"

namespace roomcast::bench {

struct NoiseAtDistance {
  double distance_m = 0;  // the nearest of a range, four for each doubling
  double sigma_mm = 0;    // standard deviation of a reading
  double share = 0;       // of all readings
};

struct SensorCondition {
  std::string sensor;
  std::vector<NoiseAtDistance> noise;  // by distance; where it sees at least 1 % of its readings
  sensor::InterferenceFigures interference;  // of the frames as they came
  sensor::InterferenceFigures filtered;      // of the frames after the filter
  double held = 0;                           // share of a frame's readings that the filter added
  double changed = 0;                        // share of a frame's readings that the filter changed
};

/// `frames` of a fixed sensor, of one size, in their order; at least one.
[[nodiscard]] SensorCondition condition_of(const std::string& sensor,
                                           const std::vector<DepthImage>& frames);

}  // namespace roomcast::bench
