// SPDX-License-Identifier: Apache-2.0
// Pose accuracy of two sensors that are placed only by a printed board which a person carries
// about: simulated rooms of every scene in which a person walks, compared with the ground truth.
// Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/live_align/pair_case.h"

namespace roomcast::bench {

struct BoardSuiteOptions {
  int rooms = 8;
  std::uint64_t seed = 1;  // of the first room; increases by one per room
  double seconds = 120;    // during which the board is carried
  double fps = 4;          // rate of tag detection
};

[[nodiscard]] Result<std::vector<PairCase>> run_board_suite(
    const BoardSuiteOptions& options, const std::function<void(std::string_view)>& progress);

}  // namespace roomcast::bench
