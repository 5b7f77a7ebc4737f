// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from shape alone, for pairs whose pictures gave no conclusive one. They are only
// proposals: shapes slide and repeat, so features, free space and colours judge them like any
// other. Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/feature/shape_features.h"
#include "roomcast/alignment/pair/spatial_vote.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

struct ShapeHypothesisOptions {
  ShapeFeatureOptions features;
  /// Coarse, because shape features are as far apart as the thinned surface points.
  VoteOptions voting{.inlier_m = 0.12F, .tolerance_m = 0.06F};

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("features", features);
    visit("voting", voting);
  }
  [[nodiscard]] Status check() const { return check_fields("ShapeHypothesisOptions", *this); }
};

/// Best first.
[[nodiscard]] std::vector<PoseHypothesis> hypotheses_by_shape(
    const DepthSurface& a, const DepthSurface& b, const ShapeHypothesisOptions& options = {},
    const MatchSupportOptions& support = {});

}  // namespace roomcast::alignment
