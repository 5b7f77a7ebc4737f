// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from shape alone, where the pictures gave none that is_conclusive. They are mere
// proposals: shapes slide and repeat, so the features, free space and colours judge them like any
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
