// SPDX-License-Identifier: Apache-2.0
// Harsh units: sensors as found in the field instead of in a laboratory. Each property is drawn at
// random from the unit's key; one file per idea:
//   noise_law.h        how noisy depth is, and how far it reaches
//   lens_error.h       the true lenses; the unit declares the nominal ones of its model, as do all
//                      other units of the model
//   depth_scale.h      all readings too long or too short, by up to 5 %
//   disparity_steps.h  structured light: steps of depth
//   pattern_holes.h    structured light: no readings patch by patch
//   color_drift.h      exposure and white balance that differ from unit to unit and wander
//   shutter.h          rolling shutter and motion blur
// A third of the units register their colour to depth, with the nominal lenses, which are wrong.
// Recordings have 3 to 30 frames, 5 to 30 a second, and colour as JPEG of quality 60.
#pragma once

#include <cstdint>

#include "roomcast/simulator/sensing/sensor_unit.h"

namespace roomcast::simulator {

/// `options.harsh` must not be kNone.
[[nodiscard]] SensorUnit make_harsh_unit(const SensingOptions& options, std::uint32_t key);

/// The length of a harsh recording, a function of its seed.
struct HarshRecording {
  int frames = 30;
  double fps = 30;
};
[[nodiscard]] HarshRecording draw_harsh_recording(std::uint64_t seed);

inline constexpr int kHarshJpegQuality = 60;
inline constexpr int kMinHarshFrames = 3, kMaxHarshFrames = 30;
inline constexpr double kMinHarshFps = 5, kMaxHarshFps = 30;

}  // namespace roomcast::simulator
