// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/shape_hypotheses.h"

#include "roomcast/alignment/feature/shape_features.h"

namespace roomcast::alignment {
namespace {

/// Coarse tolerances, because shape features are as far apart as the thinned surface points.
constexpr VoteOptions kVote{1200, 150, 16, 0.12F, 0.06F};

}  // namespace

std::vector<PoseHypothesis> hypotheses_by_shape(const DepthSurface& a, const DepthSurface& b) {
  const auto of_a = shape_features(a.samples), of_b = shape_features(b.samples);
  std::vector<PointMatch> matches;
  for (const ShapeMatch& match : match_shapes(of_a, of_b)) {
    matches.push_back({of_a[match.a].point_m, of_b[match.b].point_m, Eigen::Vector2f::Zero(),
                       Eigen::Vector2f::Zero()});
  }
  return vote_for_poses(matches, kVote);
}

}  // namespace roomcast::alignment
