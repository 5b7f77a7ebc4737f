// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from shape alone, for pairs whose pictures gave no conclusive one. They are only
// proposals: shapes slide and repeat, so features, free space and colours judge them like any
// other. Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/pair/spatial_vote.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

/// Best first.
[[nodiscard]] std::vector<PoseHypothesis> hypotheses_by_shape(const DepthSurface& a,
                                                              const DepthSurface& b);

}  // namespace roomcast::alignment
