// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/nudged_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

/// The prior, and poses moved along the floor or turned about the vertical: the usual errors of a
/// person's estimate.
std::vector<RigidTransform> starts_about(const RigidTransform& guess, const NudgeOptions& options) {
  std::vector<RigidTransform> starts = {guess};
  for (const double side : {-1.0, 1.0}) {
    RigidTransform turned = guess, across = guess, along = guess;
    turned.rotation =
        rotation_about(Eigen::Vector3d::UnitY(), side * options.aside_rad) * guess.rotation;
    across.translation_m.x() += side * options.aside_m;
    along.translation_m.z() += side * options.aside_m;
    starts.insert(starts.end(), {turned, across, along});
  }
  return starts;
}

bool is_near(const RigidTransform& pose, const RigidTransform& guess, const NudgeOptions& options) {
  const PoseDifference apart = difference(pose, guess, Eigen::Vector3d::Zero());
  return apart.distance_m < options.max_shift_m && apart.angle_rad < options.max_turn_rad;
}

/// The refined poses of all starts, and alignment's own candidates near the prior (the first
/// start). Sorted by score, without duplicates.
std::vector<PoseEvidence> refined_candidates(const PairCandidates& pair,
                                             std::span<const RigidTransform> starts_a_from_b,
                                             const NudgeOptions& options) {
  const PairOptions& of_pair = pair.options();
  std::vector<PoseEvidence> ends;
  for (const PoseEvidence& proposed : pair.ranked()) {
    if (is_near(proposed.a_from_b, starts_a_from_b.front(), options)) ends.push_back(proposed);
  }
  for (const RigidTransform& start : starts_a_from_b)
    ends.push_back(pair.examine(refined_pose(pair.a(), pair.b(), pair.matches(), start,
                                             ColorCalibration::kAsCalibrated, of_pair.refinement,
                                             of_pair.residuals)));
  std::ranges::stable_sort(ends, std::greater(), &PoseEvidence::score);
  std::vector<PoseEvidence> distinct;
  for (const PoseEvidence& end : ends) {
    const bool is_new = std::ranges::all_of(distinct, [&](const auto& better) {
      return are_rivals(end.a_from_b, better.a_from_b, of_pair.rivals);
    });
    if (is_new) distinct.push_back(end);
  }
  return distinct;
}

/// Standard deviation 2.5 m ahead of b, by the surfaces that both share.
double expected_error_ahead_m(const PairCandidates& pair, const RigidTransform& a_from_b,
                              const NudgeOptions& options) {
  const SurfaceResidualOptions& residuals = pair.options().residuals.surfaces;
  const auto partners = surface_partners(pair.a().surface, pair.b().surface, a_from_b,
                                         {options.reach_m, options.points}, residuals);
  Matrix6 information =
      surface_equations(partners, a_from_b, surface_noise(partners, residuals), residuals)
          .information.topLeftCorner<6, 6>();
  information += Matrix6::Identity();  // weak prior (1 m, 1 rad) for undetermined directions
  return expected_error_m(information, a_from_b * Eigen::Vector3d(0, 0, 2.5));
}

}  // namespace

Result<NudgedPose> refined_prior(const PairCandidates& pair, const RigidTransform& world_from_a,
                                 const RigidTransform& guess, const NudgeOptions& options) {
  std::vector<RigidTransform> starts;
  for (const RigidTransform& start : starts_about(guess, options))
    starts.push_back(world_from_a.inverse() * start);
  const auto ends = refined_candidates(pair, starts, options);
  const PoseEvidence& best = ends.front();
  const Contradiction contradicts = contradiction(best, options.evidence);
  if (contradicts == Contradiction::kShapes) {
    return unavailable("its surfaces do not fit those of " + pair.a().name +
                       " there; bring it within 20 cm and 5 degrees");
  }
  if (contradicts == Contradiction::kColors)
    return unavailable("the surfaces fit there, but the colours do not");
  if (contradicts == Contradiction::kMovement)
    return unavailable("what moves would not be where " + pair.a().name + " sees it");
  if (ends.size() > 1 && best.score - ends[1].score < options.min_lead)
    return unavailable(
        "two poses near the guess fit equally well; bring it nearer to the right one");
  const RigidTransform world_from_depth = world_from_a * best.a_from_b;
  if (!is_near(world_from_depth, guess, options))
    return unavailable("the best fit is far from the guess; bring it nearer");
  return NudgedPose{world_from_depth, 1000 * expected_error_ahead_m(pair, best.a_from_b, options),
                    pair.a().name};
}

Result<NudgedPose> refined_prior(const SensorView& view, const RigidTransform& guess,
                                 std::span<const PlacedView> others, const NudgeOptions& options,
                                 const PairOptions& pair_options) {
  const auto partner = best_partner(view, guess, others, options.evidence, pair_options.free_space);
  if (!partner)
    return unavailable(
        "there it has no overlap with a placed sensor, so the pose cannot be checked");
  return refined_prior(candidates_of(*partner->view, view, pair_options), partner->world_from_depth,
                       guess, options);
}

}  // namespace roomcast::alignment
