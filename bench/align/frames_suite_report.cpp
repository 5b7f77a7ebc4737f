// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/align/align_tally.h"
#include "bench/align/frames_suite.h"

namespace roomcast::bench {
namespace {

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

std::string mm_or_dash(const std::vector<double>& values) {
  return values.empty() ? "-" : fmt::format("{:.0f}, {:.0f}", median(values), largest(values));
}

void print_pairs(const std::string& rig, const std::string& frames,
                 const std::vector<FramesPairRow>& pairs, std::ostream& out) {
  for (const FramesPairRow& pair : pairs) {
    out << fmt::format("{:<12} {:<7} {:<8} {:>3} of {:<3} {:>6} {:>12} {:>12} {:>12} {:>12}\n", rig,
                       frames, pair.a + "-" + pair.b, pair.answered, pair.draws,
                       pair.has_truth ? std::to_string(pair.wrong) : "-",
                       mm_or_dash(pair.errors_mm), mm_or_dash(pair.spread_mm),
                       mm_or_dash(pair.ball_mm), mm_or_dash(pair.said_mm));
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
                            {"median_said_mm", median(pair.said_mm)}};
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
  out << fmt::format("{:<12} {:<7} {:<8} {:>10} {:>6} {:>12} {:>12} {:>12} {:>12}\n", "rig",
                     "frames", "pair", "answered", "wrong", "error", "spread", "ball", "said");
  for (const FramesRigRow& row : rows) {
    print_pairs(row.rig, "draws", row.pairs, out);
    print_pairs(row.rig, "all", row.all, out);
    out << fmt::format("{}: {} of {} sensors placed in {} draws, all of them in {}\n", row.rig,
                       row.placed, row.draws * row.sensors, row.draws, row.complete);
  }
  out << "\nMedian, largest in mm. Error: against the truth, 2.5 m ahead of the second sensor. "
         "Spread: the same point, from its median over\nthe draws. Ball: distance between the two "
         "places of the ball. Said: the larger expected error of the two sensors.\n";
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
