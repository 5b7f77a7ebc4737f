// SPDX-License-Identifier: Apache-2.0
// How well two sensors are placed by a printed board that somebody carries about, and by nothing
// else: simulated rooms of every scene in which somebody walks, against the truth. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/live_align/pair_case.h"

namespace roomcast::bench {

struct BoardSuiteOptions {
  int rooms = 8;
  std::uint64_t seed = 1;  // of the first room; each has the next
  double seconds = 120;    // of carrying it about
  double fps = 4;          // at which tags are looked for
};

[[nodiscard]] Result<std::vector<PairCase>> run_board_suite(
    const BoardSuiteOptions& options, const std::function<void(std::string_view)>& progress);

}  // namespace roomcast::bench
