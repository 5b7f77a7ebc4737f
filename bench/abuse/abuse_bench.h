// SPDX-License-Identifier: Apache-2.0
// `roomcast bench abuse`: how an attack on a hub affects the clients of its rooms. Four publishers
// at 30 frames a second and some viewers are measured in turns: without an attack, while another
// hub on the same machine is attacked, and while this hub is attacked. The second case shows the
// load on the machine that no hub can avoid. Latency is from before a frame is sent to its last
// byte at a viewer. Each hub runs in a process of its own; load and attacker share this process,
// and the machine with the hubs.
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
  int connections = 1000;                    // of half-open, garbage and slowloris attacks
  int bad_tokens = 10'000;                   // total over all rounds
  std::chrono::milliseconds duration{4000};  // of one measurement
};

struct AbuseRow {
  std::string attack;
  double p50_quiet_ms = 0, p99_quiet_ms = 0;
  double p99_beside_ms = 0;       // while another hub is attacked
  double p50_ms = 0, p99_ms = 0;  // under attack
  double p99_ratio = 0;           // attack / no attack, median over rounds
  double p99_ratio_beside = 0;    // attack / attack on the other hub, median over rounds
  std::uint64_t tried = 0;        // connections opened by the attacker
  double rss_before_mb = 0, rss_most_mb = 0;  // of the hub
};

/// Runs the kinds of attack one after the other. kUnavailable: the hub failed.
[[nodiscard]] Result<std::vector<AbuseRow>> run_abuse_bench(
    const AbuseBenchOptions& options, const std::function<void(const std::string&)>& progress = {});

void print_table(const std::vector<AbuseRow>& rows, std::ostream& out);
void print_json(const std::vector<AbuseRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
