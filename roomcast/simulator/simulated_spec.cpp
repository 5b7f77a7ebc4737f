// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_spec.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <numbers>
#include <optional>
#include <system_error>

#include "roomcast/geometry/rotations.h"

namespace roomcast::simulator {
namespace {

constexpr std::string_view kOptions =
    "; a simulated source is sim[:scene[,camera=kinect2|azure|d435][,speed=0..10][,color=half|full]"
    "[,interference=BURSTS_PER_MINUTE][,mutual[=no]][,bump_at=SECONDS][,bump_cm=0..100][,bump_deg="
    "0..90]"
    "[,board][,cabinet=SECONDS]["
    ",harsh[=tof|structured|mixed]][,clean]"
    "]";

Error refused(std::string_view option) {
  return {ErrorCode::kInvalidArgument,
          "\"" + std::string(option) + "\" means nothing here" + std::string(kOptions)};
}

std::optional<double> number_up_to(std::string_view text, double largest) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !(value >= 0 && value <= largest)) return std::nullopt;
  return value;
}

struct NumberOption {
  std::function<void(double)> set;
  double largest = 0;
};

std::optional<NumberOption> number_named(std::string_view name, SimulatedSpec& spec) {
  const auto into = [](auto& place, double largest) {
    return NumberOption{[&place](double value) { place = value; }, largest};
  };
  if (name == "speed") return into(spec.speed, kMaxSimulatedSpeed);
  if (name == "interference")
    return into(spec.sensing.interference_per_minute, kMaxInterferencePerMinute);
  if (name == "bump_at") return into(spec.bump_at_s, kMaxBumpAt_s);
  if (name == "bump_cm") return into(spec.bump.shift_cm, kMaxBump_cm);
  if (name == "cabinet") return into(spec.cabinet_s, kMaxCabinet_s);
  if (name == "bump_deg") return into(spec.bump.angle_deg, kMaxBump_deg);
  return std::nullopt;
}

/// Sets a valid option in `spec`; false for an unknown option or an invalid value.
bool apply(std::string_view option, SimulatedSpec& spec) {
  const std::size_t equals = std::min(option.find('='), option.size());
  const std::string_view name = option.substr(0, equals);
  const std::string_view value = option.substr(std::min(equals + 1, option.size()));
  if (name == "camera") {
    const auto model = simulator::camera_model_named(value);
    if (model) spec.sensing.camera = *model;
    return model.has_value();
  }
  if (const auto place = number_named(name, spec)) {
    const auto number = number_up_to(value, place->largest);
    if (number) place->set(*number);
    return number.has_value();
  }
  if (name == "harsh") {
    const auto harshness = simulator::harshness_named(equals < option.size() ? value : "mixed");
    if (harshness) spec.sensing.harsh = *harshness;
    spec.sensing.mutual_interference = true;
    return harshness.has_value();
  }
  if (name == "color") {
    spec.sensing.half_color = value == "half";
    return value == "half" || value == "full";
  }
  if (option == "mutual" || option == "mutual=no") {
    spec.sensing.mutual_interference = option == "mutual";
    return true;
  }
  if (option == "board") {
    spec.board = true;
    return true;
  }
  if (option == "clean") {
    spec.sensing = spec.sensing.clean();
    return true;
  }
  return false;
}

}  // namespace

RigidTransform SimulatedBump::mount_from_depth() const {
  RigidTransform bump;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.4, 1, 0.2).normalized();
  bump.rotation = rotation_about(axis, angle_deg * std::numbers::pi / 180);
  bump.translation_m = 0.01 * shift_cm * Eigen::Vector3d(1, 0.3, -0.8).normalized();
  return bump;
}

Result<SimulatedSpec> parse_simulated_spec(std::string_view text) {
  SimulatedSpec spec;
  spec.sensing.half_color = true;
  std::size_t comma = std::min(text.find(','), text.size());
  spec.scene = text.substr(0, comma);
  while (comma < text.size()) {
    const std::size_t begin = comma + 1;
    comma = std::min(text.find(',', begin), text.size());
    const std::string_view option = text.substr(begin, comma - begin);
    if (!apply(option, spec)) return refused(option);
  }
  return spec;
}

}  // namespace roomcast::simulator
