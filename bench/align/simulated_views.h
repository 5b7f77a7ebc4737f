// SPDX-License-Identifier: Apache-2.0
// Views of simulated rooms for measuring alignment: the bundles that the sensors of a room would
// send when joining, made in memory, with the true poses. Single-threaded.
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

struct SimulatedViewsOptions {
  std::string scene;
  std::uint64_t seed = 1;
  int sensors = 4;
  int frames = 5;  // averaged in each bundle
  simulator::SensingOptions sensing;
  std::size_t only_first = std::numeric_limits<std::size_t>::max();  // maximum number of sensors
};

struct SimulatedView {
  std::shared_ptr<const alignment::SensorView> view;  // null when the sensor's view cannot be used
  RigidTransform world_from_depth;                    // ground truth
  double look_cpu_s = 0;                              // CPU time of making the view
};

/// Errors of SimulatedRoom and SimulatedSensor. A sensor whose view is refused keeps its place in
/// the list, without a view.
[[nodiscard]] Result<std::vector<SimulatedView>> simulate_views(
    const SimulatedViewsOptions& options);

}  // namespace roomcast::bench
