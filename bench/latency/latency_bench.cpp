// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/latency_bench.h"

#include <algorithm>
#include <array>
#include <utility>

#include "bench/latency/latency_cases.h"

namespace roomcast::bench {

namespace {

struct Case {
  const char* name;
  const char* what;
  Status (*measure)(std::chrono::milliseconds duration, LatencyReport& report);
};

constexpr std::array kCases = {
    Case{"room", "three simulated sensors on loopback", measure_room},
    Case{"glass", "from capture to the window's pixels", measure_glass},
    Case{"internet", "20 Mbit/s, 50 ms, 1 % loss", measure_internet},
    Case{"narrow", "half of the bandwidth that is needed", measure_narrow},
    Case{"voice", "audio while frames fill a line", measure_voice},
};

}  // namespace

LatencyRow distribution(std::string name, std::string unit, std::vector<double> values) {
  std::ranges::sort(values);
  const auto quantile = [&](double q) {
    if (values.empty()) return 0.0;
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
  };
  return {std::move(name), std::move(unit), quantile(0.5), quantile(0.95), quantile(0.99)};
}

Result<LatencyReport> run_latency_bench(const LatencyBenchOptions& options,
                                        const std::function<void(const std::string&)>& progress) {
  LatencyReport report;
  for (const Case& one : kCases) {
    if (std::ranges::find(options.cases, one.name) == options.cases.end()) continue;
    if (progress) progress(std::string(one.name) + ": " + one.what);
    const Status status = one.measure(options.duration, report);
    if (status) continue;
    if (status.error().code != ErrorCode::kUnsupported) return status.error();
    report.left_out.push_back(std::string(one.name) + ": " + status.error().message);
  }
  return report;
}

}  // namespace roomcast::bench
