// SPDX-License-Identifier: Apache-2.0
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/align/align_bench.h"
#include "bench/align/fresh_suite.h"

namespace roomcast::bench {
namespace {

std::string accuracy(const AlignRow& row) {
  if (row.right == 0) return fmt::format("{:>18}", "-");
  return fmt::format("{:>5.2f} deg {:>5.0f} mm", row.median_rotation_deg,
                     row.median_translation_mm);
}

}  // namespace

void print_table(const std::vector<AlignRow>& rows, std::ostream& out) {
  out << fmt::format("{:<20} {:<8} {:<21} {:>9} {:>9} {:>6} {:>9} {:>8} {:>7}\n", "input",
                     "overlap", "method", "right", "claimed", "wrong", "rotation", "transl.",
                     "CPU");
  for (const AlignRow& row : rows) {
    out << fmt::format("{:<20} {:<8} {:<21} {:>3} of {:<3} {:>8} {:>6} {} {:>5.2f} s\n", row.input,
                       row.overlap, row.method, row.right, row.pairs, row.accepted,
                       row.accepted_wrong, accuracy(row), row.cpu_s_per_pair);
  }
}

namespace {

nlohmann::json json_of(const std::vector<AlignRow>& rows) {
  nlohmann::json json = {{"rows", nlohmann::json::array()}};
  for (const AlignRow& row : rows) {
    json["rows"].push_back({{"input", row.input},
                            {"method", row.method},
                            {"overlap", row.overlap},
                            {"pairs", row.pairs},
                            {"right", row.right},
                            {"accepted", row.accepted},
                            {"accepted_wrong", row.accepted_wrong},
                            {"median_rotation_deg", row.median_rotation_deg},
                            {"median_translation_mm", row.median_translation_mm},
                            {"cpu_s_per_pair", row.cpu_s_per_pair}});
  }
  return json;
}

}  // namespace

void print_json(const std::vector<AlignRow>& rows, std::ostream& out) {
  out << json_of(rows).dump(1) << "\n";
}

namespace {

void print_scenes(const std::vector<SceneRow>& rows, std::ostream& out) {
  out << fmt::format(
      "\nOf the pairs that share more than {:.0f} %, and of those without an answer:\n",
      100 * kSharesEnough);
  out << fmt::format("{:<14} {:<8} {:>6} {:>6} {:>8} {:>6}\n", "scene", "overlap", "pairs", "right",
                     "refused", "wrong");
  for (const SceneRow& row : rows) {
    out << fmt::format("{:<14} {:<8} {:>6} {:>6} {:>8} {:>6}\n", row.scene, row.overlap, row.pairs,
                       row.right, row.refused, row.wrong);
  }
}

nlohmann::json json_of(const std::vector<SceneRow>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const SceneRow& row : rows) {
    json.push_back({{"scene", row.scene},
                    {"overlap", row.overlap},
                    {"pairs", row.pairs},
                    {"right", row.right},
                    {"refused", row.refused},
                    {"wrong", row.wrong}});
  }
  return json;
}

}  // namespace

void print_table(const FreshSuite& suite, std::ostream& out) {
  const ErrorRatios &distances = suite.distance_ratios(), &angles = suite.angle_ratios();
  print_table(suite.rows(), out);
  print_scenes(suite.scenes(), out);
  out << fmt::format(
      "\n{} pairs in {} rooms; overlap \"none\": sensors of different rooms, \"alike\": of "
      "different rooms of the same kind (right: refused)\n"
      "of {} pairs that share more than {:.0f} %, {} were answered\n"
      "calibration of {} placed sensors: {:.0f} % err by at most twice the millimetres expected "
      "(median {:.2f} of them), {:.0f} % by at most twice the degrees (median {:.2f})\n",
      suite.pairs(), suite.rooms(), suite.sharing(), 100 * kSharesEnough, suite.sharing_answered(),
      distances.ratios.size(), 100 * distances.within_twice(), median(distances.ratios),
      100 * angles.within_twice(), median(angles.ratios));
}

void print_json(const FreshSuite& suite, std::ostream& out) {
  nlohmann::json json = json_of(suite.rows());
  json["scenes"] = json_of(suite.scenes());
  json["rooms"] = suite.rooms();
  json["pairs"] = suite.pairs();
  json["sharing"] = suite.sharing();
  json["sharing_answered"] = suite.sharing_answered();
  json["placed"] = suite.distance_ratios().ratios.size();
  json["within_twice_expected_mm"] = suite.distance_ratios().within_twice();
  json["median_error_over_expected_mm"] = median(suite.distance_ratios().ratios);
  json["within_twice_expected_deg"] = suite.angle_ratios().within_twice();
  json["median_error_over_expected_deg"] = median(suite.angle_ratios().ratios);
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
