// SPDX-License-Identifier: Apache-2.0
// Joint fit of poses and depth scales of sensors that nobody calibrated, with honest errors. Errors
// of depth and lens are smooth over a picture, so that ten thousand residuals of one patch are one
// observation, good to `smooth_sigma_m`, whatever moves or stands still there (generalised least
// squares). Lenses are used as given, because viewers use them so; focal lengths and optical
// centres that are off enter the errors as far as the data leave them open. Metres, radians.
// Single-threaded, deterministic.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/rig/joint_terms.h"

namespace roomcast::alignment {

struct JointFitOptions {
  int steps = 20;
  JointReach first, last{0.1, 0.15};
  double shrink = 0.85;
  PatchOptions patches;
  /// Of a patch, about: what simulated and real uncalibrated sensors leave; by hand.
  double smooth_sigma_m = 0.01;
  /// Of a patch of what moves or of features, besides: clothes, instants that are not quite the
  /// same, colour beside depth.
  double shape_sigma_m = 0.01;
  /// Limits of the estimated noise of a kind of evidence, in units of the sigma of its terms.
  double min_noise = 0.3, min_moving_noise = 0.5, max_noise = 1.5;
  /// Priors, one standard deviation, of sensors with nominal lenses: 3 %, 8 pixels and 5 % at most.
  double focal_sigma = 0.017, center_sigma_px = 4.6, scale_sigma = 0.03;
  /// Factor on the errors of poses, for what is not modelled: bent lenses, errors that are smooth
  /// over more than a patch. So that nine of ten placed sensors of the harsh suite's development
  /// rooms err by at most twice what is said.
  double unmodelled = 1.25;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("steps", steps, Range{0, 1000});
    visit("first", first);
    visit("last", last);
    visit("shrink", shrink, Range{0, 1});
    visit("patches", patches);
    visit("smooth_sigma_m", smooth_sigma_m, Range{1e-4, 1});
    visit("shape_sigma_m", shape_sigma_m, Range{0, 1});
    visit("min_noise", min_noise, Range{0.001, 1000});
    visit("min_moving_noise", min_moving_noise, Range{0.001, 1000});
    visit("max_noise", max_noise, Range{0.001, 1000});
    visit("focal_sigma", focal_sigma, Range{1e-6, 1});
    visit("center_sigma_px", center_sigma_px, Range{1e-3, 1000});
    visit("scale_sigma", scale_sigma, Range{1e-6, 1});
    visit("unmodelled", unmodelled, Range{1, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("JointFitOptions", *this); }
};

/// Whether scales are unknowns of the fit, or only of its errors.
enum class ScaleFit { kFixed, kFree };

struct JointFit {
  std::vector<ScaledPose> sensors;
  std::vector<Matrix6> covariance;    // of (rotation, shift) in the origin's frame
  std::vector<double> scale_sigma;    // of free scales; 0 of others
  std::vector<std::size_t> instants;  // per sensor: in which it saw what another saw moving
};

/// `scale_sigmas`: priors of the scales, one per sensor; 0: exact. Those of a fit with fixed scales
/// count for the errors only, and there without what all scales have in common (common_scale.h), if
/// none is exact.
[[nodiscard]] JointFit fit_jointly(const JointTerms& terms, std::vector<ScaledPose> start,
                                   std::size_t origin, ScaleFit scales,
                                   std::span<const double> scale_sigmas,
                                   const JointFitOptions& options = {});

}  // namespace roomcast::alignment
