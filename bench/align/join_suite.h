// SPDX-License-Identifier: Apache-2.0
// The cost of a sensor that joins a room of four: CPU time to process its bundle and to find its
// pose relative to the placed sensors. Simulated rooms, Kinect v2. Single-threaded.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::bench {

struct JoinSuiteOptions {
  int rooms = 3;  // cycles through the scenes
  std::uint64_t seed = 1;
  int there = 4;   // sensors before the join
  int frames = 3;  // averaged per sensor
  simulator::SensingOptions sensing;
};

struct JoinedRoom {
  std::string scene;
  std::uint64_t seed = 0;
  bool placed = false;     // the joining sensor
  double look_cpu_s = 0;   // surfaces and features of its bundle
  double place_cpu_s = 0;  // against the four present sensors
};

/// Errors of simulate_views.
[[nodiscard]] Result<std::vector<JoinedRoom>> run_join_suite(const JoinSuiteOptions& options,
                                                             const BenchProgress& progress);

void print_table(const std::vector<JoinedRoom>& rooms, std::ostream& out);
void print_json(const std::vector<JoinedRoom>& rooms, std::ostream& out);

}  // namespace roomcast::bench
