// SPDX-License-Identifier: Apache-2.0
// `roomcast bench latency`: end-to-end latency, and the effect of a bad network on it.
//
//   room      three simulated sensors, real codec, loopback: by stage, capture to decoded
//   glass     the same sensors: from capture to the pixels of the window
//   internet  1 MB/s over an emulated 20 Mbit/s, 50 ms, 1 % loss
//   narrow    2.5 MB/s over an emulated 10 Mbit/s, 50 ms: a viewer with half the needed rate,
//             next to 20 viewers with enough
//   voice     a speaker, and 2.9 Mbit/s of frames over an emulated 2 Mbit/s, 50 ms: the age of
//   audio
//
// The last three need root (EmulatedLink); without it they are left out and reported in `left_out`.
// Ages are wall-clock times: on a busy machine they include its load.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/figure.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

struct LatencyBenchOptions {
  std::vector<std::string> cases = {"room", "glass", "internet", "narrow", "voice"};
  std::chrono::milliseconds duration{10'000};
};

/// A distribution of one quantity.
struct LatencyRow {
  std::string name;  // "room: encoded"
  std::string unit;
  double p50 = 0, p95 = 0, p99 = 0;
};

struct LatencyReport {
  std::vector<LatencyRow> rows;
  std::vector<Figure> figures;
  std::vector<std::string> left_out;  // sentences
};

/// `progress` is called with a description of the current measurement.
[[nodiscard]] Result<LatencyReport> run_latency_bench(
    const LatencyBenchOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const LatencyReport& report, std::ostream& out);
void print_json(const LatencyReport& report, std::ostream& out);

}  // namespace roomcast::bench
