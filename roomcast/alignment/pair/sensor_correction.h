// SPDX-License-Identifier: Apache-2.0
// What a sensor's calibration may be off by, small as it is. A colour camera that looks slightly
// aside is noticed and corrected: left in, it would go into the poses. Readings that are a little
// too far are not: no view tells them from a room that is a little larger, so estimates of them
// follow every other flaw of depth (multipath above all) and made poses worse. They count as doubt
// about the poses instead. Plain data.
#pragma once

#include <Eigen/Core>

namespace roomcast::alignment {

/// Two of the colour shift; depth offset and depth scale: true depth = (1 + scale) * reading +
/// offset.
inline constexpr Eigen::Index kCorrectionUnknowns = 4;
using CorrectionVector = Eigen::Matrix<double, kCorrectionUnknowns, 1>;

struct SensorCorrection {
  Eigen::Vector2d color_shift_px = Eigen::Vector2d::Zero();  // true place = seen place + shift
};

/// By how much a measured point moves per metre of depth offset and per one of scale.
[[nodiscard]] inline Eigen::Matrix<double, 3, 2> point_by_depth(const Eigen::Vector3d& point_m) {
  Eigen::Matrix<double, 3, 2> by;
  by << point_m / point_m.z(), point_m;
  return by;
}

/// Standard deviations of what is expected of a sensor whose calibration is believed.
inline constexpr double kColorShiftSigma_px = 0.7;

/// How firmly no shift is expected, at one of so much: most colour cameras are good to a pixel, but
/// one that is not may be off by any amount (Cauchy's distribution, weighted anew at each step).
[[nodiscard]] inline double shift_expectation(const Eigen::Vector2d& shift_px) {
  return 1 / (kColorShiftSigma_px * kColorShiftSigma_px + shift_px.squaredNorm());
}

/// By how much depth may be off in a way that no view tells, one standard deviation: of each sensor
/// by itself, and of all alike (multipath makes every reading of a room too long).
struct DepthDoubt {
  double offset_m = 0.001, scale = 0.0005, common_scale = 0.0025;
};

}  // namespace roomcast::alignment
