// SPDX-License-Identifier: Apache-2.0
// Depth scales of a rig's sensors: a Kinect read 4.5 % too near. Their ratios are estimated jointly
// with the poses (joint_fit.h), from surfaces and features that stand still and from what moves at
// the same instant in two views. Still surfaces alone do not determine them (ADR 9). A factor is
// used only where it is determined and more likely than none (ADR 20). What all scales have in
// common is not determined by anything (common_scale.h).
// Single-threaded.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/alignment/rig/common_scale.h"
#include "roomcast/alignment/rig/joint_fit.h"
#include "roomcast/alignment/rig/rig_refinement.h"

namespace roomcast::alignment {

struct DepthScaleOptions {
  double calibrated = 0.9;  // prior share of sensors that need no factor, where surfaces agree
  double max_standard_error = 0.02;  // of a factor that is determined; by hand
  double min_instants = 5;  // with something that moves in two views: without it nothing tells
                            // scale from distance; by hand
  JointTermOptions terms;
  JointFitOptions fit;
  CommonScaleOptions common;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("calibrated", calibrated, Range{0, 0.9999});
    visit("max_standard_error", max_standard_error, Range{0, 1});
    visit("min_instants", min_instants, Range{0, 1e6});
    visit("terms", terms);
    visit("fit", fit);
    visit("common", common);
  }
  [[nodiscard]] Status check() const { return check_fields("DepthScaleOptions", *this); }
};

/// `sensors`: refined poses, with the belief that they are not calibrated. `pairs`: of placed
/// sensors. One for each sensor.
[[nodiscard]] std::vector<DepthScale> estimate_depth_scales(std::span<const RefinedSensor> sensors,
                                                            std::size_t origin,
                                                            std::span<const RigPair> pairs,
                                                            const DepthScaleOptions& options = {},
                                                            const ResidualOptions& residuals = {});

/// Refines poses and errors of sensors that are not calibrated by all evidence, also by what moves.
/// The belief in `sensors` stays. `scales`: the factors with which the views were made.
void refine_uncalibrated(std::size_t origin, std::span<const RigPair> pairs,
                         std::span<const DepthScale> scales, const DepthScaleOptions& options,
                         const ResidualOptions& residuals, std::vector<RefinedSensor>& sensors);

}  // namespace roomcast::alignment
