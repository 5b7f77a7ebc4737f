// SPDX-License-Identifier: Apache-2.0
// Compares the colours of surfaces that two sensors share. Both sensors' greys on one sensor's
// depth grid are compared window by window by normalised cross-correlation, so exposure and
// brightness do not matter. This distinguishes a floor from the same floor shifted by one print,
// which geometry cannot. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"

namespace roomcast::alignment {

struct PhotoConsistency {
  double textured = 0;     // share of a view that is common and has contrast, weighted by contrast
  double correlation = 0;  // mean over that, -1..1
};

/// Colour is corrected by the state's shifts.
[[nodiscard]] PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                                       const PairState& state);

}  // namespace roomcast::alignment
