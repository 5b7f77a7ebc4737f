// SPDX-License-Identifier: Apache-2.0
// The text after "sim:" on the command line: a scene and options, separated by commas.
//   lab,camera=d435,speed=0.05,color=full,interference=2,bump_at=20,bump_cm=2,bump_deg=1,board,clean
//   livingroom,cabinet=30: a cabinet is moved every 30 s
//   shelf-rows,harsh or shelf-rows,harsh=tof|structured|mixed
//   lab,mutual: the sensors' infrared light disturbs the others, as with harsh; harsh,mutual=no
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::simulator {

inline constexpr double kMaxSimulatedSpeed = 10;
inline constexpr double kMaxInterferencePerMinute = 60;

inline constexpr double kMaxBumpAt_s = 86'400, kMaxBump_cm = 100, kMaxBump_deg = 90;
inline constexpr double kMaxCabinet_s = 86'400;

/// Displacement of a sensor by a knock.
struct SimulatedBump {
  double shift_cm = 5, angle_deg = 3;

  /// The displaced pose in the sensor's original frame: sideways and back, turned left and down.
  [[nodiscard]] RigidTransform mount_from_depth() const;
};

struct SimulatedSpec {
  std::string scene;  // "": the first one
  double speed = 1;   // of all motion: 0.05 is slow motion, 0 no motion
  simulator::SensingOptions sensing;
  std::optional<double> bump_at_s;  // after opening
  SimulatedBump bump;
  bool board = false;  // a person carries the board about
  /// A cabinet stands in the room, and is elsewhere after so many seconds, and back after as many
  /// more; 0: it stays. Scene time, so all sensors see it move at once.
  std::optional<double> cabinet_s;
};

/// Half-size colour unless color=full. kInvalidArgument, naming the option, for any deviation from
/// the above.
[[nodiscard]] Result<SimulatedSpec> parse_simulated_spec(std::string_view text);

}  // namespace roomcast::simulator
