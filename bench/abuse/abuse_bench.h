// SPDX-License-Identifier: Apache-2.0
// `roomcast bench abuse`: what those who are in a room notice when others try to wear its hub down.
// Four publishers at 30 frames a second and some viewers, first in peace and then under attack, in
// turns; latency is from before a frame is sent to its last byte at a viewer. The hub runs in a
// process of its own; load and attacker share this one and the machine with it.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::bench {

struct AbuseBenchOptions {
  int viewers = 10;
  int rounds = 3;
  int connections = 1000;                    // of half-open, garbage and slowloris
  int bad_tokens = 10'000;                   // in all rounds together
  std::chrono::milliseconds duration{4000};  // of a measurement
};

struct AbuseRow {
  std::string attack;
  double p50_quiet_ms = 0, p99_quiet_ms = 0;
  double p50_ms = 0, p99_ms = 0;              // under attack
  double p99_ratio = 0;                       // median over rounds of attack over peace
  std::uint64_t tried = 0;                    // connections of the attacker
  double rss_before_mb = 0, rss_most_mb = 0;  // of the hub
};

/// Kinds one after the other. kUnavailable: the hub failed.
[[nodiscard]] Result<std::vector<AbuseRow>> run_abuse_bench(
    const AbuseBenchOptions& options, const std::function<void(const std::string&)>& progress = {});

void print_table(const std::vector<AbuseRow>& rows, std::ostream& out);
void print_json(const std::vector<AbuseRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
