// SPDX-License-Identifier: Apache-2.0
// Pose accuracy of four sensors in the corners of a room: simulated rooms with the noise and the
// smooth depth errors of a Kinect v2, compared with the ground truth. Single-threaded.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "bench/align/align_bench.h"
#include "bench/align/rig_error.h"
#include "bench/align/simulated_views.h"

namespace roomcast::bench {

struct CornersSuiteOptions {
  int rooms = 3;
  std::uint64_t seed = 1;  // of the first room; increases by one per room
  int frames = 9;          // averaged per sensor
  simulator::SensingOptions sensing;
};

struct CornersRoom {
  std::uint64_t seed = 0;
  std::size_t sensors = 0, placed = 0;
  RigError error;          // of the placed sensors
  double expected_mm = 0;  // largest expected error of any sensor, 2.5 m in front of it
  double expected_deg = 0;
};

[[nodiscard]] Result<std::vector<CornersRoom>> run_corners_suite(const CornersSuiteOptions& options,
                                                                 const BenchProgress& progress);

void print_table(const std::vector<CornersRoom>& rooms, std::ostream& out);
void print_json(const std::vector<CornersRoom>& rooms, std::ostream& out);

}  // namespace roomcast::bench
