// SPDX-License-Identifier: Apache-2.0
// Compares the texture that two sensors see on walls, floors and tables. Rooms of one kind are
// alike in shape and pattern and may differ by no more than a poster. Over a whole view that is one
// part in a hundred, too little for a mean. Therefore places are counted where both sensors see
// contrast but different patterns, even when shifted (colours may be misaligned with their
// surfaces). Only planes count, because people moving between two frames look like contradictions
// everywhere else. Both colour cameras must see the plane itself, not the outline of an object in
// front of it. Where greys agree, hues are compared: the slope of redness over brightness, which
// neither exposure nor blur changes. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/reprojected_views.h"

namespace roomcast::alignment {

/// Chosen on the rooms that ADR 12 names.
struct PlanarTextureOptions {
  int reach = 5;                   // windows of 11 x 11 grid points
  double min_filled = 0.9;         // share of a window that both see
  double min_contrast = 6;         // grey levels: standard deviation in both views
  double contradiction = 0.12;     // correlations below it contradict
  float before_m = 0.05F;          // surfaces further in front of a plane cover it
  double alike_correlation = 0.5;  // least correlation of windows alike in grey
  /// Slopes of red minus green over grey are of other hues if they differ by more, and if one is
  /// less than this share of the other, because cameras vary.
  double other_slope = 0.3, other_ratio = 0.5;
  int near_shift = 1;             // grid points: refined poses are off by no more
  int far_shift = 4;              // grid points: colours are off, near a camera and in corners
  double found_far_aside = 0.6;   // least correlation of agreement beyond near_shift
  double min_filled_aside = 0.5;  // share of a window, there

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("reach", reach, Range{1, 100});
    visit("min_filled", min_filled, Range{0.01, 1});
    visit("min_contrast", min_contrast, Range{0, 255});
    visit("contradiction", contradiction, Range{-1, 1});
    visit("before_m", before_m, Range{0, 1});
    visit("alike_correlation", alike_correlation, Range{-1, 1});
    visit("other_slope", other_slope, Range{0, 100});
    visit("other_ratio", other_ratio, Range{0, 1});
    visit("near_shift", near_shift, Range{0, 100});
    visit("far_shift", far_shift, Range{0, 100});
    visit("found_far_aside", found_far_aside, Range{-1, 1});
    visit("min_filled_aside", min_filled_aside, Range{0.01, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("PlanarTextureOptions", *this); }
};

/// Counts of judged places, as shares of a view, for both views together.
struct PlanarTexture {
  double judged = 0;
  double contradicting = 0;
  double agreement = 0;      // sum of the judged places' correlations
  double alike = 0;          // places alike in grey
  double different_hue = 0;  // places alike in grey but of another hue

  void add(const PlanarTexture& other) {
    judged += other.judged;
    contradicting += other.contradicting;
    agreement += other.agreement;
    alike += other.alike;
    different_hue += other.different_hue;
  }
  [[nodiscard]] PlanarTexture over(double points) const {
    return {judged / points, contradicting / points, agreement / points, alike / points,
            different_hue / points};
  }
  [[nodiscard]] double correlation() const { return judged > 0 ? agreement / judged : 0; }
  [[nodiscard]] double conflict() const { return judged > 0 ? contradicting / judged : 0; }
  [[nodiscard]] double hue_conflict() const { return alike > 0 ? different_hue / alike : 0; }
};

/// Colour is corrected by the state's shifts.
[[nodiscard]] PlanarTexture compare_planar_texture(const SensorView& a, const SensorView& b,
                                                   const PairState& state,
                                                   const PlanarTextureOptions& options = {},
                                                   const ReprojectionOptions& reprojection = {});

}  // namespace roomcast::alignment
