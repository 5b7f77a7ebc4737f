// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/align/align_tally.h"
#include "bench/align/frames_suite.h"
#include "bench/align/said_error.h"

namespace roomcast::bench {
namespace {

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

std::string share_or_dash(const std::vector<double>& errors_over_said) {
  if (errors_over_said.empty()) return "-";
  return fmt::format("{:.0f} %", 100 * share_within_twice(errors_over_said));
}

std::string mm_or_dash(const std::vector<double>& values) {
  return values.empty() ? "-" : fmt::format("{:.0f}, {:.0f}", median(values), largest(values));
}

void print_pairs(const std::string& rig, const std::string& frames,
                 const std::vector<FramesPairRow>& pairs, std::ostream& out) {
  for (const FramesPairRow& pair : pairs) {
    out << fmt::format(
        "{:<12} {:<7} {:<8} {:>3} of {:<3} {:>6} {:>12} {:>12} {:>12} {:>12} {:>7}\n", rig, frames,
        pair.a + "-" + pair.b, pair.answered, pair.draws,
        pair.has_truth ? std::to_string(pair.wrong) : "-", mm_or_dash(pair.errors_mm),
        mm_or_dash(pair.spread_mm), mm_or_dash(pair.ball_mm), mm_or_dash(pair.said_mm),
        share_or_dash(pair.errors_over_said));
  }
}

nlohmann::json json_of(const std::vector<FramesPairRow>& pairs) {
  nlohmann::json json = nlohmann::json::array();
  for (const FramesPairRow& pair : pairs) {
    nlohmann::json entry = {{"a", pair.a},
                            {"b", pair.b},
                            {"draws", pair.draws},
                            {"answered", pair.answered},
                            {"spread_mm", pair.spread_mm},
                            {"median_spread_mm", median(pair.spread_mm)},
                            {"ball_mm", pair.ball_mm},
                            {"median_said_mm", median(pair.said_mm)},
                            {"within_twice_said", share_within_twice(pair.errors_over_said)},
                            {"errors_over_said", pair.errors_over_said}};
    if (!pair.ball_mm.empty()) entry["median_ball_mm"] = median(pair.ball_mm);
    if (pair.has_truth) {
      entry["wrong"] = pair.wrong;
      entry["median_error_mm"] = median(pair.errors_mm);
      entry["max_error_mm"] = largest(pair.errors_mm);
      entry["median_error_deg"] = median(pair.errors_deg);
    }
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace

void print_table(const std::vector<FramesRigRow>& rows, std::ostream& out) {
  out << fmt::format("{:<12} {:<7} {:<8} {:>10} {:>6} {:>12} {:>12} {:>12} {:>12} {:>7}\n", "rig",
                     "frames", "pair", "answered", "wrong", "error", "spread", "ball", "said",
                     "within");
  for (const FramesRigRow& row : rows) {
    print_pairs(row.rig, "draws", row.pairs, out);
    print_pairs(row.rig, "all", row.all, out);
    out << fmt::format("{}: {} of {} sensors placed in {} draws, all of them in {}\n", row.rig,
                       row.placed, row.draws * row.sensors, row.draws, row.complete);
  }
  out << "\nMedian, largest in mm. Error: against the truth, 2.5 m ahead of the second sensor. "
         "Spread: the same point, from its median over\nthe draws. Ball: distance between the two "
         "places of the ball. Said: the larger expected error of the two sensors. Within: answers "
         "that err by at most twice what is "
         "said (against the truth: with the error of the room's scale).\n";
}

void print_json(const std::vector<FramesRigRow>& rows, std::ostream& out) {
  nlohmann::json json = {{"rigs", nlohmann::json::array()}};
  for (const FramesRigRow& row : rows) {
    json["rigs"].push_back({{"rig", row.rig},
                            {"draws", row.draws},
                            {"sensors", row.sensors},
                            {"placed", row.placed},
                            {"complete_draws", row.complete},
                            {"depth_scales", row.depth_scales},
                            {"pairs", json_of(row.pairs)},
                            {"all_frames", json_of(row.all)}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
