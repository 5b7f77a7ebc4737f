// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses from matches most of which may be wrong: second-order spatial compatibility (SC2,
// Chen et al., CVPR 2022). Two matches are compatible when their points are equally far apart in
// both views. A match gets votes from the compatible matches that are compatible with each other.
// No random choice: the same matches give the same hypotheses. Metres. Thread-safe (no state).
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

/// The prototype's, where it has them, else chosen on the development rooms
/// (alignment_options.h).
struct VoteOptions {
  std::size_t max_matches = 1200;  // the heaviest are used
  std::size_t max_seeds = 150;
  std::size_t max_hypotheses = 16;
  float inlier_m = 0.06F;  // largest distance of a match that agrees with a pose
  /// Largest difference of two distances that are compatible: a constant, and a share of them.
  float tolerance_m = 0.02F, tolerance_per_metre = 0.012F;
  float min_apart_m = 0.06F;         // nearer points do not constrain rotation
  std::size_t seed_neighbours = 25;  // matches in the first fit of a seed
  int seed_refinements = 4;          // later fits, to all matches that agree
  float softening_m = 0.02F;         // residual at which a match still has half its weight
  double min_support = 1.5;          // match_support().weight of a hypothesis
  /// Hypotheses that differ by less are the same.
  double same_angle_rad = 3 * std::numbers::pi / 180, same_distance_m = 0.15;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_matches", max_matches, Range{4, 20000});  // memory grows with the square
    visit("max_seeds", max_seeds, Range{1, 20000});
    visit("max_hypotheses", max_hypotheses, Range{1, 1000});
    visit("inlier_m", inlier_m, Range{0.001, 10});
    visit("tolerance_m", tolerance_m, Range{0, 10});
    visit("tolerance_per_metre", tolerance_per_metre, Range{0, 1});
    visit("min_apart_m", min_apart_m, Range{0, 10});
    visit("seed_neighbours", seed_neighbours, Range{3, 20000});
    visit("seed_refinements", seed_refinements, Range{0, 100});
    visit("softening_m", softening_m, Range{1e-4, 10});
    visit("min_support", min_support, Range{0, 1000});
    visit("same_angle_rad", same_angle_rad, Range{0, std::numbers::pi});
    visit("same_distance_m", same_distance_m, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("VoteOptions", *this); }
};

struct PoseHypothesis {
  RigidTransform a_from_b;
  double support = 0;  // match_support().weight of the agreeing matches
};

/// Most support first, without duplicates.
[[nodiscard]] std::vector<PoseHypothesis> vote_for_poses(std::span<const PointMatch> matches,
                                                         const VoteOptions& options = {},
                                                         const MatchSupportOptions& support = {});

}  // namespace roomcast::alignment
