// SPDX-License-Identifier: Apache-2.0
// What follows "sim:" on the command line: a scene and options, separated by commas.
//   lab,camera=d435,speed=0.05,color=full,interference=2,clean
#pragma once

#include <string>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/source/simulator/sensing/sensing_options.h"

namespace roomcast {

inline constexpr double kMaxSimulatedSpeed = 10;
inline constexpr double kMaxInterferencePerMinute = 60;

struct SimulatedSpec {
  std::string scene;  // "": the first one
  double speed = 1;   // of all motion: 0.05 is slow motion, 0 stands still
  sim::SensingOptions sensing;
};

/// Half-size colour unless color=full. kInvalidArgument, naming the option, for what is not as
/// above.
[[nodiscard]] Result<SimulatedSpec> parse_simulated_spec(std::string_view text);

}  // namespace roomcast
