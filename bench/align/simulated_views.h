// SPDX-License-Identifier: Apache-2.0
// Views of simulated rooms, for measuring alignment on rooms that nobody has looked at: what the
// sensors of a room would send on joining, made in memory, with where they truly stand.
// Single-threaded.
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
  std::size_t only_first = std::numeric_limits<std::size_t>::max();  // of the sensors
};

struct SimulatedView {
  std::shared_ptr<const alignment::SensorView> view;  // nothing when the sensor's view is of no use
  RigidTransform world_from_depth;                // the truth
  double look_cpu_s = 0;                          // CPU time of making the view
};

/// Errors of SimulatedRoom and SimulatedSensor; a sensor that is refused keeps its place, without a
/// view.
[[nodiscard]] Result<std::vector<SimulatedView>> simulate_views(
    const SimulatedViewsOptions& options);

}  // namespace roomcast::bench
