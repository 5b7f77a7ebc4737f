// SPDX-License-Identifier: Apache-2.0
// Do both sensors see the same picture on the surfaces they share? One's colours, as they fall into
// the other's depth grid, are compared window by window: normalised cross-correlation, so exposure
// and brightness do not matter. It tells a floor from the same floor one print further, which no
// geometry can. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"

namespace roomcast::alignment {

struct PhotoConsistency {
  double textured = 0;     // share of a view that is common and has contrast, weighted by contrast
  double correlation = 0;  // mean over that, -1..1
};

/// With colour corrected as the state says.
[[nodiscard]] PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                                       const PairState& state);

}  // namespace roomcast::alignment
