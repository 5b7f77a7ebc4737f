// SPDX-License-Identifier: Apache-2.0
// The facts of each camera model: nominal lenses, and the figures of its depth errors. Sources
// beside the numbers in sensor_profile.cpp. Immutable data.
#pragma once

#include "roomcast/geometry/camera_model.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::simulator {

enum class DepthPrinciple { kTimeOfFlight, kStereo };

struct SensorProfile {
  CameraModel model = CameraModel::kKinect2;
  DepthPrinciple principle = DepthPrinciple::kTimeOfFlight;
  SensorCalibration nominal;
  float nearest_m = 0, farthest_m = 0;     // no reading outside
  float lateral_sigma_mm = 0;              // where along a surface a pixel looks
  float lost_signal = 0, safe_signal = 0;  // amplitudes: no reading below, always above
  float saturating_signal = 0;             // amplitude: no reading from here on; 0: never
  float lost_at_edge = 0;                  // share of the readings on an edge that are given up
  float baseline_mm = 0, subpixel = 0;     // stereo only
  float bias_offset_mm = 0;                // largest constant error of a unit (time of flight)
  float bias_wave_mm = 0;                  // amplitude of the smooth error over the picture
  float bias_wiggle_mm = 0;                // amplitude of the periodic error over range
  float bias_disparity_px = 0;             // largest smooth error of the disparity (stereo)

  /// One deviation along the axis, in millimetres, for a surface of the reference reflectance.
  [[nodiscard]] float axial_sigma_mm(float z_m, float theta) const;
};

[[nodiscard]] SensorProfile profile_of(CameraModel model, bool half_color);

}  // namespace roomcast::simulator
