// SPDX-License-Identifier: Apache-2.0
// What two sensors may both see: matches of their features, each with what it is worth. Thread-safe
// (no state).
#pragma once

#include <vector>

#include "roomcast/align/pair/rigid_fit.h"
#include "roomcast/align/sensor_view.h"

namespace roomcast::align {

/// For every feature of a view the distance to its nearest look-alike in the whole rig
/// (feature/repeats.h).
struct LookAlikes {
  std::vector<float> of_picture_features, of_rectified_features;
};

/// One for each view, in their order: what repeats in any of them is known to all.
[[nodiscard]] std::vector<LookAlikes> look_alikes_of_rig(
    const std::vector<const SensorView*>& views);

[[nodiscard]] std::vector<PointMatch> match_features(const SensorView& a, const LookAlikes& alike_a,
                                                     const SensorView& b,
                                                     const LookAlikes& alike_b);

}  // namespace roomcast::align
