// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/fanout/fanout_bench.h"

namespace roomcast::bench {

void print_table(const FanoutReport& report, std::ostream& out) {
  out << fmt::format("{:<18}{:<10}{:>8}{:>15}{:>7}{:>9}{:>9}{:>9}{:>12}{:>12}\n", "server", "load",
                     "viewers", "deliv./CPU-s", "cores", "limit=1", "p50 ms", "p99 ms", "kB/viewer",
                     "growth kB/s");
  for (const FanoutRow& row : report.rows) {
    out << fmt::format(
        "{:<18}{:<10}{:>8}{:>15.0f}{:>7.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>12.1f}{:>12.1f}\n",
        row.engine, row.load, row.viewers, row.deliveries_per_cpu_s, row.cores, row.ratio_to_limit,
        row.p50_ms, row.p99_ms, row.rss_per_viewer_kb, row.rss_growth_kb_per_s);
  }
  for (const std::string& sentence : report.left_out) out << "left out: " << sentence << "\n";
}

void print_json(const FanoutReport& report, std::ostream& out) {
  auto rows = nlohmann::ordered_json::array();
  for (const FanoutRow& row : report.rows) {
    rows.push_back({{"engine", row.engine},
                    {"load", row.load},
                    {"viewers", row.viewers},
                    {"tls", row.tls},
                    {"deliveries_per_cpu_s", row.deliveries_per_cpu_s},
                    {"cores", row.cores},
                    {"ratio_to_limit", row.ratio_to_limit},
                    {"p50_ms", row.p50_ms},
                    {"p99_ms", row.p99_ms},
                    {"rss_per_viewer_kb", row.rss_per_viewer_kb},
                    {"rss_growth_kb_per_s", row.rss_growth_kb_per_s}});
  }
  out << nlohmann::ordered_json{{"rows", rows}, {"left_out", report.left_out}}.dump(2) << "\n";
}

}  // namespace roomcast::bench
