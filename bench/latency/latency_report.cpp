// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/latency/latency_bench.h"

namespace roomcast::bench {

void print_table(const LatencyReport& report, std::ostream& out) {
  out << fmt::format("{:<34}{:>6}{:>9}{:>9}{:>9}\n", "", "", "p50", "p95", "p99");
  for (const LatencyRow& row : report.rows) {
    out << fmt::format("{:<34}{:>6}{:>9.1f}{:>9.1f}{:>9.1f}\n", row.name, row.unit, row.p50,
                       row.p95, row.p99);
  }
  for (const Figure& figure : report.figures) {
    out << fmt::format("{:<34}{:>6}{:>9.1f}\n", figure.name, figure.unit, figure.value);
  }
  for (const std::string& sentence : report.left_out) out << "left out: " << sentence << "\n";
}

void print_json(const LatencyReport& report, std::ostream& out) {
  nlohmann::ordered_json json;
  json["rows"] = nlohmann::ordered_json::array();
  for (const LatencyRow& row : report.rows) {
    json["rows"].push_back({{"name", row.name},
                            {"unit", row.unit},
                            {"p50", row.p50},
                            {"p95", row.p95},
                            {"p99", row.p99}});
  }
  json["figures"] = json_of(report.figures);
  json["left_out"] = report.left_out;
  out << json.dump(2) << "\n";
}

}  // namespace roomcast::bench
