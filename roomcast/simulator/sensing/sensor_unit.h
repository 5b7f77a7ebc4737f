// SPDX-License-Identifier: Apache-2.0
// SensorUnit: one device: its true lenses, which differ from the nominal ones by manufacturing
// tolerances; its reported calibration, which is close to the truth; and its white balance. All are
// functions of (seed, index). Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "roomcast/simulator/sensing/color_drift.h"
#include "roomcast/simulator/sensing/sensor_profile.h"
#include "roomcast/simulator/sensing/shutter.h"

namespace roomcast::simulator {

/// Maximum calibration errors; each is uniform between minus and plus this.
inline constexpr double kFocalError = 0.001;  // share of the focal length
inline constexpr double kDepthCentreError_px = 0.3;
inline constexpr double kColorCentreError_px = 0.6;     // at 1920 pixels
inline constexpr double kExtrinsicError_rad = 0.00035;  // 0.02 degrees about each axis
inline constexpr double kExtrinsicError_m = 0.0003;     // along each axis

struct SensorUnit {
  SensorProfile profile;
  SensorCalibration exact;                      // used for rendering
  SensorCalibration reported;                   // written to camera.json
  std::array<float, 3> color_gain = {1, 1, 1};  // of linear light, red first
  std::uint32_t key = 0;                        // for all of this unit's random numbers

  // Of harsh units (harsh_unit.h); these values are those of all others.
  double depth_scale = 1;  // true depth = depth_scale * reading
  ColorDrift drift;
  Shutter shutter;
  int jpeg_quality = 90;  // of its colour in a recording
  /// The calibration by which the device registers its colour to depth; nothing: it does not.
  std::optional<SensorCalibration> registered_by;
};

[[nodiscard]] SensorUnit make_unit(const SensingOptions& options, std::uint64_t seed, int index);

}  // namespace roomcast::simulator
