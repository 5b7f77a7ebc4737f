// SPDX-License-Identifier: Apache-2.0
// The cases of `roomcast bench latency`. Each adds its rows to the report.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "bench/latency/latency_bench.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

[[nodiscard]] Status measure_room(std::chrono::milliseconds duration, LatencyReport& report);
[[nodiscard]] Status measure_glass(std::chrono::milliseconds duration, LatencyReport& report);
[[nodiscard]] Status measure_internet(std::chrono::milliseconds duration, LatencyReport& report);
[[nodiscard]] Status measure_narrow(std::chrono::milliseconds duration, LatencyReport& report);
[[nodiscard]] Status measure_voice(std::chrono::milliseconds duration, LatencyReport& report);

/// Reorders `values`.
[[nodiscard]] LatencyRow distribution(std::string name, std::string unit,
                                      std::vector<double> values);

}  // namespace roomcast::bench
