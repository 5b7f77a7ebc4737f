// SPDX-License-Identifier: Apache-2.0
// `roomcast bench abuse`: what those who are in a room notice when others try to wear its hub down.
// Four publishers at 30 frames a second and some viewers: in peace, while another hub on the same
// machine is attacked, and while this one is, in turns. What the second shows an attacker takes
// from the machine, and no hub can give back. Latency is from before a frame is sent to its last
// byte at a viewer. Each hub runs in a process of its own; load and attacker share this one and the
// machine with them.
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
  double p99_beside_ms = 0;                   // while another hub is attacked
  double p50_ms = 0, p99_ms = 0;              // under attack
  double p99_ratio = 0;                       // median over rounds of attack over peace
  double p99_ratio_beside = 0;                // and of attack over that on the other hub
  std::uint64_t tried = 0;                    // connections of the attacker
  double rss_before_mb = 0, rss_most_mb = 0;  // of the hub
};

/// Kinds one after the other. kUnavailable: the hub failed.
[[nodiscard]] Result<std::vector<AbuseRow>> run_abuse_bench(
    const AbuseBenchOptions& options, const std::function<void(const std::string&)>& progress = {});

void print_table(const std::vector<AbuseRow>& rows, std::ostream& out);
void print_json(const std::vector<AbuseRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
