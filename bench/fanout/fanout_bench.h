// SPDX-License-Identifier: Apache-2.0
// `roomcast bench fanout`: the cost of sending the same frames to many viewers. Compares the hub
// with a minimal server and with message brokers.
//   max     one publisher, as fast as all viewers take it, two frames on the way
//   room    four publishers at 30 frames a second, 50 viewers
//   stall   the same, and every tenth viewer never reads
//   heads   four publishers at 10 frames a second, 500 viewers who tell where their heads are, to
//           the hub alone
//   elsewhere   the same, and they tell how wide they see, and see nothing of what sensors see
// CPU time is the server's alone; latency is from before a frame is sent to its last byte at a
// viewer. Engines take turns within a round and the median of the rounds is reported, because the
// machine may be busy with other work.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::bench {

struct FanoutBenchOptions {
  std::vector<int> viewers = {100, 500};  // of the runs at full speed
  int rounds = 3;
  std::chrono::milliseconds duration{1200};  // of a run at full speed; others take twice as long
  std::size_t frame_bytes = 20'480;
  std::vector<std::string> loads = {"max", "room", "stall", "heads", "elsewhere"};
  std::vector<std::string> only;  // engines whose name contains one of these; empty: all
};

struct FanoutRow {
  std::string engine, load;
  int viewers = 0;
  bool tls = false;
  double deliveries_per_cpu_s = 0;
  double cores = 0;           // the server's CPU time, as a share of the time that passed
  double ratio_to_limit = 0;  // in the same round, load and encryption; 0: no limit was measured
  double p50_ms = 0, p99_ms = 0;
  double rss_per_viewer_kb = 0;
  double rss_growth_kb_per_s = 0;
};

struct FanoutReport {
  std::vector<FanoutRow> rows;
  std::vector<std::string> left_out;  // one sentence for each missing engine: the reason
};

/// `progress` is called with a description of the next run. kUnavailable: the hub, or the limit,
/// failed.
[[nodiscard]] Result<FanoutReport> run_fanout_bench(
    const FanoutBenchOptions& options,
    const std::function<void(const std::string&)>& progress = {});

void print_table(const FanoutReport& report, std::ostream& out);
/// One JSON object: {"rows": [...], "left_out": [...]}.
void print_json(const FanoutReport& report, std::ostream& out);

}  // namespace roomcast::bench
