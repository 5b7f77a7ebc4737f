// SPDX-License-Identifier: Apache-2.0
// Depth scales of a rig's sensors, relative to the origin's: a Kinect read 4.5 % too near. They are
// estimated jointly with the poses, from surfaces and features that stand still and from what moves
// at the same instant in two views. What stands still alone does not determine them (ADR 9).
// Single-threaded.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/moving_partners.h"
#include "roomcast/alignment/rig/pose_selection.h"
#include "roomcast/alignment/rig/rig_refinement.h"

namespace roomcast::alignment {

struct DepthScale {
  double factor = 1;          // on the sensor's readings; 1 where it is not determined
  double standard_error = 0;  // of an estimated factor; 0 where there is none
};

struct DepthScaleOptions {
  double sigma = 0.03;      // prior: of a sensor that was never calibrated; kinects differ by 4 %
  double calibrated = 0.9;  // prior share of sensors that need no factor
  double max_standard_error = 0.012;  // of a factor that is determined
  double min_moving = 100;  // independent partners that move, of a sensor: without them nothing
                            // tells scale from distance
  // The errors of what stands still are smooth (a bent wall, multipath), so that a pair's surfaces
  // count as few independent ones. By hand.
  double independent_surfaces = 20, independent_features = 10;
  int steps = 24;
  std::size_t points = 4000;  // surface points of each view of a pair
  float reach_m = 0.15F, min_reach_m = 0.05F, shrink = 0.85F;
  float moving_reach_m = 0.25F, min_moving_reach_m = 0.1F;
  MovingPartnerOptions moving;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("sigma", sigma, Range{1e-4, 1});
    visit("calibrated", calibrated, Range{0, 0.9999});
    visit("max_standard_error", max_standard_error, Range{0, 1});
    visit("min_moving", min_moving, Range{0, 1e6});
    visit("independent_surfaces", independent_surfaces, Range{1, 1e6});
    visit("independent_features", independent_features, Range{1, 1e6});
    visit("steps", steps, Range{0, 1000});
    visit("points", points, Range{1, 1e6});
    visit("reach_m", reach_m, Range{0.001, 10});
    visit("min_reach_m", min_reach_m, Range{0.001, 10});
    visit("shrink", shrink, Range{0, 1});
    visit("moving_reach_m", moving_reach_m, Range{0.001, 10});
    visit("min_moving_reach_m", min_moving_reach_m, Range{0.001, 10});
    visit("moving", moving);
  }
  [[nodiscard]] Status check() const { return check_fields("DepthScaleOptions", *this); }
};

/// `sensors`: refined poses, corrections included. `pairs`: of placed sensors. One for each sensor.
[[nodiscard]] std::vector<DepthScale> estimate_depth_scales(std::span<const RefinedSensor> sensors,
                                                            std::size_t origin,
                                                            std::span<const RigPair> pairs,
                                                            const DepthScaleOptions& options = {},
                                                            const ResidualOptions& residuals = {});

}  // namespace roomcast::alignment
