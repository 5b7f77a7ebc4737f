// SPDX-License-Identifier: Apache-2.0
// ProcessStats: what this process takes of its machine. Source: getrusage(2), proc(5).
// Threading: no state.
#pragma once

#include <cstdint>

namespace roomcast::hub {

struct ProcessStats {
  double cpu_s = 0;                  // user and system, of all its threads, since it began
  std::uint64_t resident_bytes = 0;  // memory that is in use now; 0 where nobody says
};

[[nodiscard]] ProcessStats process_stats();

}  // namespace roomcast::hub
