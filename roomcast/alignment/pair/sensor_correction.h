// SPDX-License-Identifier: Apache-2.0
// Small calibration errors of a sensor. A slight pointing error of the colour camera is estimated
// and corrected, because it would otherwise enter the poses. Depth that reads slightly too far is
// not corrected: no view distinguishes it from a slightly larger room, so estimates of it follow
// every other depth error (multipath above all) and made poses worse. Depth errors enter the
// uncertainty of the poses instead. Plain data.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

/// Two for the colour shift, then depth offset and depth scale: true depth = (1 + scale) * reading
/// + offset.
inline constexpr Eigen::Index kCorrectionUnknowns = 4;
using CorrectionVector = Eigen::Matrix<double, kCorrectionUnknowns, 1>;

struct SensorCorrection {
  Eigen::Vector2d color_shift_px = Eigen::Vector2d::Zero();  // true place = seen place + shift
};

/// Derivative of a measured point by depth offset (metres) and by depth scale.
[[nodiscard]] inline Eigen::Matrix<double, 3, 2> point_by_depth(const Eigen::Vector3d& point_m) {
  Eigen::Matrix<double, 3, 2> by;
  by << point_m / point_m.z(), point_m;
  return by;
}

struct ColorShiftOptions {
  double sigma_px = 0.7;  // standard deviation of a calibrated sensor's colour shift (ADR 9)

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("sigma_px", sigma_px, Range{0.01, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("ColorShiftOptions", *this); }
};

/// Weight of the prior for zero shift, at the current shift. Most colour cameras are accurate to a
/// pixel, but the others may be off by any amount (Cauchy distribution, reweighted at each step).
[[nodiscard]] inline double shift_prior_weight(const Eigen::Vector2d& shift_px,
                                               const ColorShiftOptions& options = {}) {
  return 1 / (options.sigma_px * options.sigma_px + shift_px.squaredNorm());
}

/// Standard deviations of depth errors that no view reveals: of each sensor by itself, and common
/// to all (multipath makes every reading of a room too long). As expected errors have to be on
/// simulated rooms (ADR 9).
///
/// How well surfaces agree tells calibrated sensors from others: calibrated ones disagree by 0.2 to
/// 0.5 mm, uncalibrated ones by 0.5 to 2.1 mm, simulated and real (ADR 18, ADR 23): least where
/// only two views share little. The scale is doubted more, the more surfaces disagree.
struct DepthUncertainty {
  double offset_m = 0.001, scale = 0.0005, common_scale = 0.0025;
  double uncalibrated_scale = 0.04;     // of a sensor that nobody calibrated
  double uncalibrated_from_m = 0.0007;  // disagreement that makes both equally likely
  double uncalibrated_steepness = 6;    // power of the disagreement
  /// The same for a pose that is weighed against another estimate of it. A stated error may be too
  /// large; too small a weight would leave calibrated sensors where a person's walk had placed
  /// them, although their surfaces determine the pose better (ADR 23).
  double weighed_uncalibrated_from_m = 0.001, weighed_uncalibrated_steepness = 4;

  /// Belief that sensors are not calibrated, 0 to 1, given how far their surfaces disagree smoothly
  /// (RigScatter::disagreement_m).
  [[nodiscard]] double uncalibrated_belief(double disagreement_m) const;
  /// These uncertainties, given that disagreement: those that are said.
  [[nodiscard]] DepthUncertainty given(double disagreement_m) const;
  /// Those by which a pose is weighed.
  [[nodiscard]] DepthUncertainty weighed_given(double disagreement_m) const;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("offset_m", offset_m, Range{0, 1});
    visit("scale", scale, Range{0, 1});
    visit("common_scale", common_scale, Range{0, 1});
    visit("uncalibrated_scale", uncalibrated_scale, Range{0, 1});
    visit("uncalibrated_from_m", uncalibrated_from_m, Range{1e-6, 1});
    visit("uncalibrated_steepness", uncalibrated_steepness, Range{1, 100});
    visit("weighed_uncalibrated_from_m", weighed_uncalibrated_from_m, Range{1e-6, 1});
    visit("weighed_uncalibrated_steepness", weighed_uncalibrated_steepness, Range{1, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("DepthUncertainty", *this); }
};

}  // namespace roomcast::alignment
