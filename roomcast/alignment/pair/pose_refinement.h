// SPDX-License-Identifier: Apache-2.0
// Refines a pose by a few Gauss-Newton (ICP) steps on some surface points per view and the
// features that agree, so that hypotheses of the same answer converge and can be compared. Metres.
// Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/feature_residuals.h"
#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {

/// Assumed registration of colour to depth. Colour is off by a few pixels where the calibration is
/// slightly wrong or the camera moved between both pictures.
enum class ColorCalibration { kAsCalibrated, kUncertain };

/// Residuals of surfaces and features, for a pair and for a whole rig.
struct ResidualOptions {
  SurfaceResidualOptions surfaces;
  FeatureResidualOptions features;
  ColorShiftOptions color_shift;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("surfaces", surfaces);
    visit("features", features);
    visit("color_shift", color_shift);
  }
  [[nodiscard]] Status check() const { return check_fields("ResidualOptions", *this); }
};

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct PoseRefinementOptions {
  int max_steps = 16;
  std::size_t points = 1500;  // surface points of each view
  /// Partners are sought within reach_m, which shrinks from step to step, down to min_reach_m.
  float reach_m = 0.12F, min_reach_m = 0.05F, shrink = 0.86F;
  float feature_reach_m = 0.08F;                    // of matches that take part
  double feature_sigma_px = kUsualFeatureSigma_px;  // of a feature; the prototype's
  double surface_noise = kUsualNoise;               // in units of the depth noise
  double still = 1e-4;  // a smaller step, radians and metres, is the last

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_steps", max_steps, Range{0, 1000});
    visit("points", points, Range{1, 1e6});
    visit("reach_m", reach_m, Range{0.001, 10});
    visit("min_reach_m", min_reach_m, Range{0.001, 10});
    visit("shrink", shrink, Range{0, 1});
    visit("feature_reach_m", feature_reach_m, Range{0.001, 10});
    visit("feature_sigma_px", feature_sigma_px, Range{0.01, 100});
    visit("surface_noise", surface_noise, Range{0.001, 1000});
    visit("still", still, Range{0, 1});
  }
  [[nodiscard]] Status check() const {
    if (Status status = check_fields("PoseRefinementOptions", *this); !status) return status;
    return check_at_most("PoseRefinementOptions", "min_reach_m", double(min_reach_m), "reach_m",
                         double(reach_m));
  }
};

/// Converges from up to about 10 cm away.
[[nodiscard]] PairState refined_pose(const SensorView& a, const SensorView& b,
                                     std::span<const PointMatch> matches,
                                     const RigidTransform& a_from_b,
                                     ColorCalibration color = ColorCalibration::kAsCalibrated,
                                     const PoseRefinementOptions& options = {},
                                     const ResidualOptions& residuals = {});

}  // namespace roomcast::alignment
