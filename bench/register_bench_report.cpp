// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

#include "bench/register_bench.h"

namespace roomcast::bench {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const RegisterBenchRow& row) {
  return {{"input", row.input},
          {"version", row.version},
          {"cpu_ms", row.cpu_ms},
          {"frames_per_cpu_s", row.frames_per_cpu_s},
          {"times_reference", row.times_reference},
          {"seen_share", row.seen_share}};
}

}  // namespace

void print_json(const RegisterBenchReport& report, std::ostream& out) {
  ordered_json rows = ordered_json::array();
  for (const RegisterBenchRow& row : report.rows) rows.push_back(to_json(row));
  const ordered_json json = {{"depth_width", report.depth_width},
                             {"depth_height", report.depth_height},
                             {"color_width", report.color_width},
                             {"color_height", report.color_height},
                             {"rows", rows}};
  out << json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << "\n";
}

void print_table(const RegisterBenchReport& report, std::ostream& out) {
  out << report.color_width << "x" << report.color_height << " colour into " << report.depth_width
      << "x" << report.depth_height << " depth, one core\n"
      << "input                                  version    CPU ms  frames/s  times reference  "
         "seen\n";
  for (const RegisterBenchRow& row : report.rows) {
    out << std::left << std::setw(39) << row.input << std::setw(10) << row.version << std::right
        << std::fixed << std::setprecision(2) << std::setw(7) << row.cpu_ms << std::setprecision(0)
        << std::setw(10) << row.frames_per_cpu_s << std::setprecision(2) << std::setw(17)
        << row.times_reference << std::setprecision(3) << std::setw(6) << row.seen_share << "\n";
  }
}

}  // namespace roomcast::bench
