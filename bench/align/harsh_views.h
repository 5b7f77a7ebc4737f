// SPDX-License-Identifier: Apache-2.0
// Views of harsh simulated sensors (simulator/sensing/harsh_unit.h): the bundles that they would
// send, with the true poses, depth scales and surfaces. A bundle has as many frames as the rig's
// recording, and its colour has been a JPEG. Single-threaded.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/core/result.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::bench {

struct HarshView {
  std::shared_ptr<const alignment::SensorView> view;  // null when the sensor's view cannot be used
  // The truth:
  RigidTransform world_from_depth;
  double depth_scale = 1;  // true depth = depth_scale * reading
  /// What it sees, where it has readings, by its exact lens.
  std::shared_ptr<const alignment::DepthSurface> surface;
};

struct HarshViewsOptions {
  std::string scene;
  simulator::Harshness sensors = simulator::Harshness::kMixed;
  std::uint64_t seed = 1;
  int count = 4;                                                     // of the room's sensors
  std::size_t only_first = std::numeric_limits<std::size_t>::max();  // maximum number of views
};

/// Errors of SimulatedRoom and SimulatedSensor.
[[nodiscard]] Result<std::vector<HarshView>> harsh_views(const HarshViewsOptions& options);

}  // namespace roomcast::bench
