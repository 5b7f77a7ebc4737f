// SPDX-License-Identifier: Apache-2.0
// What a sensor's calibration may be off by, small as it is: a colour camera that looks slightly
// aside. Left in, such errors go into the poses, so they are estimated with them, held near zero by
// what calibrations usually achieve. Plain data.
#pragma once

#include <Eigen/Core>

namespace roomcast::align {

struct SensorCorrection {
  Eigen::Vector2d color_shift_px = Eigen::Vector2d::Zero();  // true place = seen place + shift
};

/// Standard deviation of what is expected of a sensor whose calibration is believed.
inline constexpr double kColorShiftSigma_px = 0.7;

}  // namespace roomcast::align
