// SPDX-License-Identifier: Apache-2.0
// What it costs that a sensor joins a room of four: CPU time of looking at what it sent, and of
// finding its place among sensors that are placed. Simulated rooms, Kinect v2. Single-threaded.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::bench {

struct JoinSuiteOptions {
  int rooms = 3;  // scene after scene
  std::uint64_t seed = 1;
  int there = 4;   // sensors before
  int frames = 3;  // averaged for each sensor
  simulator::SensingOptions sensing;
};

struct JoinedRoom {
  std::string scene;
  std::uint64_t seed = 0;
  bool placed = false;     // the sensor that joined
  double look_cpu_s = 0;   // surfaces and features of what it sent
  double place_cpu_s = 0;  // against the four that were there
};

/// Errors of simulate_views.
[[nodiscard]] Result<std::vector<JoinedRoom>> run_join_suite(const JoinSuiteOptions& options,
                                                             const BenchProgress& progress);

void print_table(const std::vector<JoinedRoom>& rooms, std::ostream& out);
void print_json(const std::vector<JoinedRoom>& rooms, std::ostream& out);

}  // namespace roomcast::bench
