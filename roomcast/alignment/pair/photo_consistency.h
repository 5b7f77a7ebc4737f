// SPDX-License-Identifier: Apache-2.0
// Compares the colours of surfaces that two sensors share. Both sensors' greys on one sensor's
// depth grid are compared window by window by normalised cross-correlation, so exposure and
// brightness do not matter. This distinguishes a floor from the same floor shifted by one print,
// which geometry cannot. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/reprojected_views.h"

namespace roomcast::alignment {

/// Chosen on the development rooms (alignment_options.h).
struct PhotoConsistencyOptions {
  int reach = 5;                // windows of 11 x 11 grid points
  double min_filled = 0.5;      // share of a window that both see
  double min_contrast = 4;      // grey levels: standard deviation in either view
  double full_contrast = 25;    // at which a window has full weight
  std::size_t min_points = 50;  // common to both

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("reach", reach, Range{1, 100});
    visit("min_filled", min_filled, Range{0.01, 1});
    visit("min_contrast", min_contrast, Range{0, 255});
    visit("full_contrast", full_contrast, Range{0.1, 255});
    visit("min_points", min_points, Range{1, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("PhotoConsistencyOptions", *this); }
};

struct PhotoConsistency {
  double textured = 0;     // share of a view that is common and has contrast, weighted by contrast
  double correlation = 0;  // mean over that, -1..1
};

/// Colour is corrected by the state's shifts.
[[nodiscard]] PhotoConsistency check_photo_consistency(
    const SensorView& a, const SensorView& b, const PairState& state,
    const PhotoConsistencyOptions& options = {}, const ReprojectionOptions& reprojection = {});

}  // namespace roomcast::alignment
