// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_spec.h"

#include <charconv>
#include <optional>
#include <system_error>

namespace roomcast {
namespace {

constexpr std::string_view kOptions =
    "; a simulated source is sim[:scene[,camera=kinect2|azure|d435][,speed=0..10][,color=half|full]"
    "[,interference=BURSTS_PER_MINUTE][,clean]]";

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

/// Whether the option is one, with a legal value; `spec` has it then.
bool apply(std::string_view option, SimulatedSpec& spec) {
  const std::size_t equals = std::min(option.find('='), option.size());
  const std::string_view name = option.substr(0, equals);
  const std::string_view value = option.substr(std::min(equals + 1, option.size()));
  if (name == "camera") {
    const auto model = sim::camera_model_named(value);
    if (model) spec.sensing.camera = *model;
    return model.has_value();
  }
  if (name == "speed" || name == "interference") {
    const bool speed = name == "speed";
    const auto number = number_up_to(value, speed ? kMaxSimulatedSpeed : kMaxInterferencePerMinute);
    if (number) (speed ? spec.speed : spec.sensing.interference_per_minute) = *number;
    return number.has_value();
  }
  if (name == "color") {
    spec.sensing.half_color = value == "half";
    return value == "half" || value == "full";
  }
  if (option == "clean") {
    spec.sensing = spec.sensing.clean();
    return true;
  }
  return false;
}

}  // namespace

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

}  // namespace roomcast
