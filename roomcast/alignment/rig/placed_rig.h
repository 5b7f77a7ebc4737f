// SPDX-License-Identifier: Apache-2.0
// Computes the report from the pairs' candidates: selection, joint refinement, check, world frame.
// Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/rig/depth_scales.h"
#include "roomcast/alignment/rig/pose_selection.h"
#include "roomcast/alignment/rig/refusal.h"
#include "roomcast/alignment/rig/rig_check.h"
#include "roomcast/alignment/rig/rig_refinement.h"
#include "roomcast/alignment/rig/world_frame.h"

namespace roomcast::alignment {

struct PlacingOptions {
  /// Evidence with which a pair takes part in refinement, if it is not strong: support or score,
  /// and overlap, with at most this conflict. Chosen on the development rooms
  /// (alignment_options.h).
  double holding_support = 6, holding_score = 6, holding_overlap = 0.03, holding_conflict = 0.12;
  /// Pointing error of a lens whose centre is off by half a pixel; no view reveals it (ADR 9).
  double pointing_sigma_rad = 0.001;
  /// Surface points of each view, and their reach, for the residual in the report. By hand.
  std::size_t reported_points = 20'000;
  float reported_reach_m = 0.05F;
  /// Belief that sensors are not calibrated from which poses are refined by all evidence
  /// (depth_scales.h).
  double uncalibrated = 0.9;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("holding_support", holding_support, Range{0, 1e6});
    visit("holding_score", holding_score, Range{0, 1e6});
    visit("holding_overlap", holding_overlap, Range{0, 1});
    visit("holding_conflict", holding_conflict, Range{0, 1});
    visit("pointing_sigma_rad", pointing_sigma_rad, Range{0, 1});
    visit("reported_points", reported_points, Range{1, 1e6});
    visit("reported_reach_m", reported_reach_m, Range{0.001, 10});
    visit("uncalibrated", uncalibrated, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("PlacingOptions", *this); }
};

/// All of a rig, from the features of its views to the world frame.
struct RigOptions {
  PairOptions pair;
  PoseSelectionOptions selection;
  RigRefinementOptions refinement;
  RigCheckOptions contradiction;
  DepthScaleOptions depth_scales;
  PlacingOptions placing;
  RefusalOptions refusal;
  WorldFrameOptions world_frame;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("pair", pair);
    visit("selection", selection);
    visit("refinement", refinement);
    visit("contradiction", contradiction);
    visit("depth_scales", depth_scales);
    visit("placing", placing);
    visit("refusal", refusal);
    visit("world_frame", world_frame);
  }
  [[nodiscard]] Status check() const { return check_fields("RigOptions", *this); }
};

/// Depth scales at the poses that fit best, before these are checked: a wrong scale makes true
/// poses contradict. 1 for sensors whose poses are unknown.
[[nodiscard]] std::vector<DepthScale> rig_depth_scales(std::size_t sensors,
                                                       std::span<const RigPair> pairs,
                                                       const RigOptions& options = {});

/// `pairs` are all pairs of `views`. `scales`: the factors with which the views were made, one for
/// each view, or none.
[[nodiscard]] AlignmentReport place_rig(std::span<const SensorView* const> views,
                                        std::span<const RigPair> pairs,
                                        const RigOptions& options = {},
                                        std::span<const DepthScale> scales = {});

}  // namespace roomcast::alignment
