// SPDX-License-Identifier: Apache-2.0
#include "bench/line/line_bench.h"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {

Result<LineReport> run_line_bench(const LineBenchOptions& options,
                                  const std::function<void(const std::string&)>& progress) {
  using Measure = Status (*)(const LineBenchOptions&,
                             const std::function<void(const std::string&)>&, LineReport&);
  constexpr std::pair<std::string_view, Measure> kCases[] = {
      {"unwatched", measure_unwatched}, {"rate", measure_rate},      {"uplink", measure_uplink},
      {"auto", measure_auto},           {"late", measure_late},      {"loss", measure_loss},
      {"viewer", measure_viewer},       {"looking", measure_looking}};
  LineReport report;
  for (const auto& [name, measure] : kCases) {
    if (std::ranges::find(options.cases, name) == options.cases.end()) continue;
    if (auto status = measure(options, progress, report); !status) return status.error();
  }
  return report;
}

void print_table(const LineReport& report, std::ostream& out) {
  for (const Figure& figure : report.figures) {
    out << fmt::format("{:<60}{:>10.2f} {}\n", figure.name, figure.value, figure.unit);
  }
}

void print_json(const LineReport& report, std::ostream& out) {
  nlohmann::ordered_json json;
  json["figures"] = json_of(report.figures);
  out << json.dump(2) << "\n";
}

}  // namespace roomcast::bench
