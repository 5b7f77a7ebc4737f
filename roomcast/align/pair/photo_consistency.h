// SPDX-License-Identifier: Apache-2.0
// Do both sensors see the same picture on the surfaces they share? One's colours, as they fall into
// the other's depth grid, are compared window by window: normalised cross-correlation, so exposure
// and brightness do not matter. It tells a floor from the same floor one print further, which no
// geometry can. Thread-safe (no state).
#pragma once

#include "roomcast/align/sensor_view.h"

namespace roomcast::align {

struct PhotoConsistency {
  double textured = 0;     // share of a view that is common and has contrast, weighted by contrast
  double correlation = 0;  // mean over that, -1..1
};

[[nodiscard]] PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                                       const RigidTransform& a_from_b);

}  // namespace roomcast::align
