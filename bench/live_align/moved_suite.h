// SPDX-License-Identifier: Apache-2.0
// Detection time for moved sensors, and false alarm rate for sensors that were not moved: simulated
// rooms of every scene with walking people. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::bench {

struct MovedSuiteOptions {
  std::uint64_t seed = 1;
  double minutes = 10;              // observation time of an unmoved sensor of each scene
  int pushes = 6;                   // of each kind, per scene
  std::vector<std::string> scenes;  // none: all
};

/// The pushes of one size in one scene.
struct PushTally {
  int pushes = 0, noticed = 0;
  double longest_s = 0;  // until one was detected
};

struct MovedRow {
  std::string scene;
  int checks = 0, alarms = 0;      // of the unmoved sensor
  PushTally two_cm, half_degree;   // must be detected
  PushTally one_cm, fifth_degree;  // should be tolerated
  double detector_ms = 0;          // CPU time of one check
};

[[nodiscard]] Result<std::vector<MovedRow>> run_moved_suite(
    const MovedSuiteOptions& options, const std::function<void(std::string_view)>& progress);

void print_table(const std::vector<MovedRow>& rows, std::ostream& out);
void print_json(const std::vector<MovedRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
