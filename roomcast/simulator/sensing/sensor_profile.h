// SPDX-License-Identifier: Apache-2.0
// SensorProfile: nominal lenses and depth error figures of each camera model. Sources are next to
// the numbers in sensor_profile.cpp. Immutable data.
#pragma once

#include "roomcast/geometry/camera_model.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::simulator {

enum class DepthPrinciple { kTimeOfFlight, kStereo, kStructuredLight };

/// Stereo and structured light both measure a disparity.
[[nodiscard]] inline bool measures_disparity(DepthPrinciple principle) {
  return principle != DepthPrinciple::kTimeOfFlight;
}

struct SensorProfile {
  CameraModel model = CameraModel::kKinect2;
  DepthPrinciple principle = DepthPrinciple::kTimeOfFlight;
  SensorCalibration nominal;
  float nearest_m = 0, farthest_m = 0;     // no reading outside
  float lateral_sigma_mm = 0;              // lateral position error along the surface
  float lost_signal = 0, safe_signal = 0;  // amplitudes: never a reading below, always above
  float saturating_signal = 0;             // amplitude above which there is no reading; 0: never
  float lost_at_edge = 0;                  // discarded share of the readings on an edge
  float amplitude_noise_mm = 0;         // axial noise at amplitude 1, inversely proportional to it
  float baseline_mm = 0, subpixel = 0;  // stereo and structured light
  float disparity_step_px = 0;          // disparities are multiples of this; 0: of any size
  float bias_offset_mm = 0;             // maximum constant error of a unit (time of flight)
  float bias_wave_mm = 0;               // amplitude of the smooth error over the picture
  float bias_wiggle_mm = 0;             // amplitude of the periodic error over range
  float bias_disparity_px = 0;  // maximum smooth error of the disparity (stereo, structured light)

  /// Axial standard deviation in millimetres, for a surface of the reference reflectance.
  [[nodiscard]] float axial_sigma_mm(float z_m, float theta) const;
};

[[nodiscard]] SensorProfile profile_of(CameraModel model, bool half_color);

}  // namespace roomcast::simulator
