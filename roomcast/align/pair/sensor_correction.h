// SPDX-License-Identifier: Apache-2.0
// What a sensor's calibration may be off by, small as it is: a colour camera that looks slightly
// aside, readings that are a little too far. Left in, such errors go into the poses, so they are
// estimated with them, held near zero by what calibrations usually achieve. Plain data.
#pragma once

#include <Eigen/Core>

namespace roomcast::align {

/// Two of the colour shift, depth offset, depth scale.
inline constexpr Eigen::Index kCorrectionUnknowns = 4;
using CorrectionVector = Eigen::Matrix<double, kCorrectionUnknowns, 1>;

struct SensorCorrection {
  Eigen::Vector2d color_shift_px = Eigen::Vector2d::Zero();  // true place = seen place + shift
  double depth_offset_m = 0, depth_scale = 0;  // true depth = (1 + scale) * reading + offset

  /// A point that the depth camera measured, as it is.
  [[nodiscard]] Eigen::Vector3d corrected(const Eigen::Vector3d& point_m) const {
    return (1 + depth_scale + depth_offset_m / point_m.z()) * point_m;
  }
  /// By how much that moves per metre of offset and per one of scale.
  [[nodiscard]] static Eigen::Matrix<double, 3, 2> point_by_depth(const Eigen::Vector3d& point_m) {
    Eigen::Matrix<double, 3, 2> by;
    by << point_m / point_m.z(), point_m;
    return by;
  }

  [[nodiscard]] CorrectionVector vector() const {
    return {color_shift_px.x(), color_shift_px.y(), depth_offset_m, depth_scale};
  }
  void add(const CorrectionVector& step) {
    color_shift_px += step.head<2>();
    depth_offset_m += step(2);
    depth_scale += step(3);
  }
};

/// Standard deviations of what is expected of a sensor whose calibration is believed.
inline constexpr double kColorShiftSigma_px = 0.7;
inline constexpr double kDepthOffsetSigma_m = 0.003;
inline constexpr double kDepthScaleSigma = 0.0025;

}  // namespace roomcast::align
