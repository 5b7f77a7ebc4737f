// SPDX-License-Identifier: Apache-2.0
// DepthBias: the systematic error of one depth camera. Time of flight: a constant offset of the
// unit and a smooth one over the picture (Wasenmueller & Stricker, "Comparison of Kinect v1 and v2
// depth images in terms of accuracy and precision", ACCV workshops 2016), and a periodic one over
// range because the modulation is not a pure sine ("wiggling": Lindner & Kolb, "Lateral and depth
// calibration of PMD-distance sensors", ISVC 2006). Stereo: a smooth error of the disparity, so
// that the depth error grows with z^2 (Grunnet-Jepsen et al., Intel). The amounts are the
// profile's; each unit draws its own. Immutable.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

class DepthBias {
 public:
  /// No error.
  DepthBias() = default;
  DepthBias(const SensorProfile& profile, std::uint32_t unit_key);

  /// Error in millimetres; positive: too far.
  [[nodiscard]] float at(int x, int y, float z_m) const {
    if (wave_.empty()) return 0.0F;
    return stereo_mm_ > 0.0F ? wave_.at(x, y) * z_m * z_m * stereo_mm_
                             : offset_mm_ + wave_.at(x, y) + wiggle_mm(z_m);
  }

 private:
  [[nodiscard]] float wiggle_mm(float z_m) const;

  Image<float> wave_;  // millimetres, or pixels of disparity
  float offset_mm_ = 0, wiggle_mm_ = 0, wiggle_phase_ = 0;
  float stereo_mm_ = 0;  // millimetres per pixel of disparity at one metre; 0: time of flight
};

}  // namespace roomcast::simulator
