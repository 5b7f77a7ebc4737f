// SPDX-License-Identifier: Apache-2.0
// How well two opposite sensors are placed by somebody who walks through both views, and
// then settle on what both see of the room: simulated rooms of every scene with people in it,
// against the truth. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/live_align/pair_case.h"

namespace roomcast::bench {

struct WalkerSuiteOptions {
  int rooms = 16;
  std::uint64_t seed = 1;  // of the first room; each has the next
  double seconds = 20;     // of walking
  double fps = 8;          // at which heads are looked for
  bool unaware = false;    // people do what they do in that room, instead of walking about
};

[[nodiscard]] Result<std::vector<PairCase>> run_walker_suite(
    const WalkerSuiteOptions& options, const std::function<void(std::string_view)>& progress);

}  // namespace roomcast::bench
