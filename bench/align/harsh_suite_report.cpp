// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/align/align_tally.h"
#include "bench/align/harsh_suite.h"

namespace roomcast::bench {
namespace {

std::vector<HarshRow> with_sums(std::vector<HarshRow> rows) {
  for (const HarshPart part : {HarshPart::kDevelopment, HarshPart::kJudged}) {
    HarshRow sum = sum_of(rows, part);
    if (sum.rigs > 0) rows.push_back(std::move(sum));
  }
  return rows;
}

}  // namespace

void print_table(const std::vector<HarshRow>& rows, std::ostream& out) {
  out << fmt::format(
      "{:<12} {:<26} {:>5} {:>10} {:>9} {:>6} {:>9} {:>10} {:>9} {:>9} {:>13} {:>7}\n", "part",
      "kind", "pairs", "over 15 %", "answered", "wrong", "elsewhere", "strangers", "median", "",
      "within twice", "scale");
  for (const HarshRow& row : with_sums(rows)) {
    out << fmt::format(
        "{:<12} {:<26} {:>5} {:>3} of {:>3} {:>9} {:>6} {:>9} {:>3} of {:>3} {:>6.0f} mm {:>5.2f} "
        "deg "
        "{:>4.0f} % of {:>3} {:>5.1f} %\n",
        row.part, row.kind, row.pairs, row.sharing_answered, row.sharing, row.answered, row.wrong,
        row.elsewhere, row.strangers_answered, row.strangers, median(row.errors_mm),
        median(row.errors_deg), 100 * row.within_twice(), row.ratios.size(),
        100 * median(row.scale_errors));
  }
  out << "\nPairs of one room; answered of those that share more than 15 % of their surface; all "
         "answers; wrong\nof those (5 degrees or 10 cm); of these elsewhere (12 degrees or 50 cm); "
         "answers to pairs of two rooms, all of "
         "which are wrong, too; median error\n2.5 m ahead; errors at most twice as large as said; "
         "median error of the ratio of two depth scales.\n";
}

void print_json(const std::vector<HarshRow>& rows, std::ostream& out) {
  nlohmann::json json = {{"kinds", nlohmann::json::array()}};
  for (const HarshRow& row : with_sums(rows)) {
    json["kinds"].push_back({{"kind", row.kind},
                             {"part", row.part},
                             {"rigs", row.rigs},
                             {"refused_views", row.refused_views},
                             {"pairs", row.pairs},
                             {"sharing", row.sharing},
                             {"sharing_answered", row.sharing_answered},
                             {"answered", row.answered},
                             {"wrong", row.wrong},
                             {"elsewhere", row.elsewhere},
                             {"strangers", row.strangers},
                             {"strangers_answered", row.strangers_answered},
                             {"median_error_mm", median(row.errors_mm)},
                             {"median_error_deg", median(row.errors_deg)},
                             {"said", row.ratios.size()},
                             {"within_twice_said", row.within_twice()},
                             {"median_error_over_said", median(row.ratios)},
                             {"median_scale_error", median(row.scale_errors)},
                             {"errors_mm", row.errors_mm},
                             {"errors_deg", row.errors_deg},
                             {"errors_over_said", row.ratios},
                             {"scale_errors", row.scale_errors}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
