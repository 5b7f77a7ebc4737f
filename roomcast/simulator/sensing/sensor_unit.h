// SPDX-License-Identifier: Apache-2.0
// One device: how its lenses differ from the model's nominal ones (as production does), what its
// own calibration says of them (nearly the truth), and how its colours differ. All a function of
// (seed, index). Plain data.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

/// Largest calibration errors; each is uniform between minus and plus this.
inline constexpr double kFocalError = 0.001;  // share of the focal length
inline constexpr double kDepthCentreError_px = 0.3;
inline constexpr double kColorCentreError_px = 0.6;     // at 1920 pixels
inline constexpr double kExtrinsicError_rad = 0.00035;  // 0.02 degrees about each axis
inline constexpr double kExtrinsicError_m = 0.0003;     // along each axis

struct SensorUnit {
  SensorProfile profile;
  SensorCalibration exact;                      // renders the pictures
  SensorCalibration reported;                   // goes into camera.json
  std::array<float, 3> color_gain = {1, 1, 1};  // of linear light, red first
  std::uint32_t key = 0;                        // of all this unit's random numbers
};

[[nodiscard]] SensorUnit make_unit(const SensingOptions& options, std::uint64_t seed, int index);

}  // namespace roomcast::simulator
