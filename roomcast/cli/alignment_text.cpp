// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/alignment_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

nlohmann::json json_of(const std::optional<RigidTransform>& transform) {
  if (!transform) return nullptr;
  return row_major_from_transform(*transform);
}

nlohmann::json json_of(const align::SensorReport& sensor) {
  return {{"id", sensor.id},
          {"placed", sensor.placed},
          {"world_from_depth", json_of(sensor.world_from_depth)},
          {"expected_error_mm", sensor.expected_error_mm},
          {"expected_error_deg", sensor.expected_error_deg},
          {"color_shift_px",
           {sensor.correction.color_shift_px.x(), sensor.correction.color_shift_px.y()}},
          {"reason", sensor.reason}};
}

nlohmann::json json_of(const align::PairReport& pair) {
  return {{"a", pair.a},
          {"b", pair.b},
          {"accepted", pair.accepted},
          {"b_from_a", json_of(pair.b_from_a)},
          {"overlap", pair.overlap},
          {"inliers", pair.inliers},
          {"residual_mm", pair.residual_mm},
          {"conflict", pair.conflict},
          {"correlation", pair.correlation},
          {"margin", pair.margin},
          {"reason", pair.reason}};
}

std::string place_text(const align::SensorReport& sensor) {
  if (!sensor.placed) return "apart";
  const Eigen::Vector3d& at = sensor.world_from_depth->translation_m;
  return fmt::format("at ({:6.2f}, {:5.2f}, {:6.2f}) m, +-{:.0f} mm, {:.2f} deg", at.x(), at.y(),
                     at.z(), sensor.expected_error_mm, sensor.expected_error_deg);
}

}  // namespace

std::string alignment_json(const align::AlignmentReport& report) {
  nlohmann::json json = {{"sensors", nlohmann::json::array()}, {"pairs", nlohmann::json::array()}};
  for (const auto& sensor : report.sensors) json["sensors"].push_back(json_of(sensor));
  for (const auto& pair : report.pairs) json["pairs"].push_back(json_of(pair));
  return json.dump(1) + "\n";
}

std::string alignment_table(const align::AlignmentReport& report) {
  std::string text;
  if (!report.sensors.empty()) text += fmt::format("{:<10} {:<44} {}\n", "sensor", "place", "why");
  for (const auto& sensor : report.sensors) {
    text += fmt::format("{:<10} {:<44} {}\n", sensor.id, place_text(sensor), sensor.reason);
  }
  if (report.pairs.empty()) return text;
  text += fmt::format("{}{:<10} {:<10} {:<8} {:>7} {:>7} {:>9}  {}\n", text.empty() ? "" : "\n",
                      "a", "b", "", "overlap", "inliers", "residual", "why");
  for (const auto& pair : report.pairs) {
    text += fmt::format("{:<10} {:<10} {:<8} {:>5.0f} % {:>7} {:>6.1f} mm  {}\n", pair.a, pair.b,
                        pair.accepted ? "accepted" : "refused", 100 * pair.overlap, pair.inliers,
                        pair.residual_mm, pair.reason);
  }
  return text;
}

}  // namespace roomcast::cli
