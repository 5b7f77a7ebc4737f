// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/shape_hypotheses.h"

namespace roomcast::alignment {

std::vector<PoseHypothesis> hypotheses_by_shape(const DepthSurface& a, const DepthSurface& b,
                                                const ShapeHypothesisOptions& options,
                                                const MatchSupportOptions& support) {
  const auto of_a = shape_features(a.samples, options.features),
             of_b = shape_features(b.samples, options.features);
  std::vector<PointMatch> matches;
  for (const ShapeMatch& match : match_shapes(of_a, of_b)) {
    matches.push_back({of_a[match.a].point_m, of_b[match.b].point_m, Eigen::Vector2f::Zero(),
                       Eigen::Vector2f::Zero()});
  }
  return vote_for_poses(matches, options.voting, support);
}

}  // namespace roomcast::alignment
