// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/alignment_text.h"

#include <charconv>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

nlohmann::json json_of(const std::optional<RigidTransform>& transform) {
  if (!transform) return nullptr;
  return row_major_from_transform(*transform);
}

nlohmann::json number_if(bool known, double number) {
  return known ? nlohmann::json(number) : nlohmann::json(nullptr);
}

nlohmann::json json_of(const alignment::SensorReport& sensor) {
  return {{"id", sensor.id},
          {"placed", sensor.placed},
          {"world_from_depth", json_of(sensor.world_from_depth)},
          {"expected_error_mm", sensor.expected_error_mm},
          {"expected_error_deg", sensor.expected_error_deg},
          {"color_shift_px",
           {sensor.correction.color_shift_px.x(), sensor.correction.color_shift_px.y()}},
          {"depth_scale", sensor.depth_scale},
          {"depth_scale_standard_error",
           number_if(sensor.depth_scale_standard_error > 0, sensor.depth_scale_standard_error)},
          {"overlap", sensor.overlap},
          {"inliers", sensor.inliers},
          {"residual_mm", number_if(sensor.overlap > 0, sensor.residual_mm)},
          {"reason", sensor.reason}};
}

nlohmann::json json_of(const alignment::PairReport& pair) {
  return {{"a", pair.a},
          {"b", pair.b},
          {"accepted", pair.accepted},
          {"b_from_a", json_of(pair.b_from_a)},
          {"overlap", pair.overlap},
          {"inliers", pair.inliers},
          {"residual_mm", number_if(pair.b_from_a.has_value(), pair.residual_mm)},
          {"expected_error_mm", number_if(pair.expected_error_mm > 0, pair.expected_error_mm)},
          {"conflict", pair.conflict},
          {"correlation", pair.correlation},
          {"margin", pair.margin},
          {"reason", pair.reason}};
}

nlohmann::json json_of(const alignment::AlignmentReport& report) {
  nlohmann::json json = {{"sensors", nlohmann::json::array()},
                         {"pairs", nlohmann::json::array()},
                         {"uncalibrated_belief", report.uncalibrated_belief},
                         {"scale_error", report.scale_error}};
  for (const auto& sensor : report.sensors) json["sensors"].push_back(json_of(sensor));
  for (const auto& pair : report.pairs) json["pairs"].push_back(json_of(pair));
  return json;
}

/// The number whose decimal form is the float's shortest: 0.1, not 0.10000000149.
double decimal(float number) {
  const std::string text = fmt::format("{}", number);
  double shortest = 0;
  std::from_chars(text.data(), text.data() + text.size(), shortest);
  return shortest;
}

/// A number, a duration's count, an array of numbers, or a struct that lists its fields.
template <class Value>
nlohmann::json json_of_option(const Value& value) {
  if constexpr (std::is_same_v<Value, float>) {
    return decimal(value);
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return value;
  } else if constexpr (requires { value.count(); }) {
    return value.count();
  } else if constexpr (requires { value.size(); }) {
    nlohmann::json numbers = nlohmann::json::array();
    for (const auto number : value) numbers.push_back(json_of_option(number));
    return numbers;
  } else {
    nlohmann::json fields;
    value.for_each_field([&](std::string_view name, const auto& field, auto...) {
      fields[std::string(name)] = json_of_option(field);
    });
    return fields;
  }
}

std::string place_text(const alignment::SensorReport& sensor) {
  if (!sensor.placed) return "apart";
  const Eigen::Vector3d& at = sensor.world_from_depth->translation_m;
  return fmt::format("at ({:6.2f}, {:5.2f}, {:6.2f}) m, +-{:.0f} mm, {:.2f} deg", at.x(), at.y(),
                     at.z(), sensor.expected_error_mm, sensor.expected_error_deg);
}

/// Text for a figure that exists for placed sensors only.
std::string millimetres(bool known, double number_mm) {
  return known ? fmt::format("{:.1f} mm", number_mm) : "";
}

std::string shared_text(double overlap, int inliers, const std::string& residual) {
  return fmt::format("{:>5.0f} % {:>7} {:>9}", 100 * overlap, inliers, residual);
}

/// An error of the room's scale that is worth a sentence, as a share.
constexpr double kNotableScaleError = 0.005;

/// Factors on readings, and doubts about calibrations, in sentences; empty if there are none.
std::string calibration_text(const alignment::AlignmentReport& report) {
  std::string factors, reference, text;
  for (const auto& sensor : report.sensors) {
    if (sensor.depth_scale == 1) continue;
    factors +=
        fmt::format("{}{} {:.3f}", factors.empty() ? "" : ", ", sensor.id, sensor.depth_scale);
    if (sensor.depth_scale_standard_error > 0) {
      factors += fmt::format(" (+-{:.3f})", sensor.depth_scale_standard_error);
    } else {
      reference = sensor.id;
    }
  }
  if (!factors.empty())
    text += fmt::format("\nThese poses need depth multiplied by: {}.{}\n", factors,
                        reference.empty() ? "" : " Errors are relative to " + reference + ".");
  if (report.uncalibrated_belief >= alignment::PlacingOptions{}.uncalibrated) {
    text +=
        "\nSurfaces disagree as those of sensors do that nobody calibrated. `roomcast calibrate` "
        "measures a sensor's lens and depth";
    text += factors.empty() ? "; a recording in which somebody walks through all views reveals "
                              "depth that is too long or too short.\n"
                            : ".\n";
  }
  if (report.scale_error > kNotableScaleError)
    text += fmt::format(
        "\nAll distances may be too long or too short alike, by {:.1f} %: nothing that is seen "
        "tells "
        "the room's scale. The errors above do not contain this.\n",
        100 * report.scale_error);
  return text;
}

}  // namespace

std::string alignment_json(const alignment::AlignmentReport& report) {
  return json_of(report).dump(1) + "\n";
}

std::string alignment_json(const alignment::AlignmentReport& report,
                           const alignment::AlignmentOptions& options) {
  nlohmann::json json = json_of(report);
  json["options"] = json_of_option(options);
  return json.dump(1) + "\n";
}

std::string alignment_table(const alignment::AlignmentReport& report) {
  constexpr auto kShared = "overlap inliers  residual";
  std::string text;
  if (!report.sensors.empty())
    text += fmt::format("{:<10} {:<44} {}  {}\n", "sensor", "place", kShared, "why");
  for (const auto& sensor : report.sensors) {
    const bool known = sensor.overlap > 0;
    const auto residual = millimetres(known, sensor.residual_mm);
    text += fmt::format("{:<10} {:<44} {:>25}  {}\n", sensor.id, place_text(sensor),
                        known ? shared_text(sensor.overlap, sensor.inliers, residual) : "",
                        sensor.reason);
  }
  if (report.pairs.empty()) return text;
  text += fmt::format("{}{:<10} {:<10} {:<8} {} {:>9}  {}\n", text.empty() ? "" : "\n", "a", "b",
                      "", kShared, "expected", "why");
  for (const auto& pair : report.pairs) {
    const bool known = pair.b_from_a.has_value();
    const auto residual = millimetres(known, pair.residual_mm);
    text += fmt::format(
        "{:<10} {:<10} {:<8} {} {:>9}  {}\n", pair.a, pair.b,
        pair.accepted ? "accepted" : "refused", shared_text(pair.overlap, pair.inliers, residual),
        millimetres(pair.expected_error_mm > 0, pair.expected_error_mm), pair.reason);
  }
  return text + calibration_text(report);
}

}  // namespace roomcast::cli
