// SPDX-License-Identifier: Apache-2.0
// ProcessStats: processor time and memory of this process. Source: getrusage(2), proc(5).
// Threading: no state.
#pragma once

#include <cstdint>

namespace roomcast::hub {

struct ProcessStats {
  double cpu_s = 0;                  // user and system time of all threads since the start
  std::uint64_t resident_bytes = 0;  // memory in use now; 0: unknown (no /proc)
};

[[nodiscard]] ProcessStats process_stats();

}  // namespace roomcast::hub
