// SPDX-License-Identifier: Apache-2.0
// Pose accuracy of two opposite sensors that are placed by a person who walks through both views
// and then refined on the surfaces that both see: simulated rooms of every scene with people,
// compared with the ground truth. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/live_align/pair_case.h"

namespace roomcast::bench {

struct PersonSuiteOptions {
  int rooms = 16;
  std::uint64_t seed = 1;  // of the first room; increases by one per room
  double seconds = 20;     // of walking
  double fps = 8;          // rate of head detection
  bool unaware = false;    // people follow the room's usual activities instead of walking about
};

[[nodiscard]] Result<std::vector<PairCase>> run_person_suite(
    const PersonSuiteOptions& options, const std::function<void(std::string_view)>& progress);

}  // namespace roomcast::bench
