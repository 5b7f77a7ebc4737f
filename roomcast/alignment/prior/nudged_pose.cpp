// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/nudged_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {
namespace {

constexpr double kFurthest_m = 0.6, kFurthest_rad = 0.35;  // from the prior to the result
constexpr double kMinLead = 4;                             // in score, over a rival
constexpr double kSettledReach_m = 0.05;
constexpr double kBeside_m = 0.15, kBeside_rad = 0.07;

/// The prior, and poses moved along the floor or turned about the vertical: the usual errors of a
/// person's estimate.
std::vector<RigidTransform> starts_about(const RigidTransform& guess) {
  std::vector<RigidTransform> starts = {guess};
  for (const double side : {-1.0, 1.0}) {
    RigidTransform turned = guess, across = guess, along = guess;
    turned.rotation =
        Eigen::AngleAxisd(side * kBeside_rad, Eigen::Vector3d::UnitY()).toRotationMatrix() *
        guess.rotation;
    across.translation_m.x() += side * kBeside_m;
    along.translation_m.z() += side * kBeside_m;
    starts.insert(starts.end(), {turned, across, along});
  }
  return starts;
}

bool is_near(const RigidTransform& pose, const RigidTransform& guess) {
  const PoseDifference apart = difference(pose, guess, Eigen::Vector3d::Zero());
  return apart.distance_m < kFurthest_m && apart.angle_rad < kFurthest_rad;
}

/// The refined poses of all starts, and alignment's own candidates near the prior (the first
/// start). Sorted by score, without duplicates.
std::vector<PoseEvidence> refined_candidates(const PairCandidates& pair,
                                             std::span<const RigidTransform> starts_a_from_b) {
  std::vector<PoseEvidence> ends;
  for (const PoseEvidence& proposed : pair.ranked()) {
    if (is_near(proposed.a_from_b, starts_a_from_b.front())) ends.push_back(proposed);
  }
  for (const RigidTransform& start : starts_a_from_b)
    ends.push_back(pair.examine(refined_pose(pair.a(), pair.b(), pair.matches(), start)));
  std::ranges::stable_sort(ends, std::greater(), &PoseEvidence::score);
  std::vector<PoseEvidence> distinct;
  for (const PoseEvidence& end : ends) {
    const bool is_new = std::ranges::all_of(
        distinct, [&](const auto& better) { return are_rivals(end.a_from_b, better.a_from_b); });
    if (is_new) distinct.push_back(end);
  }
  return distinct;
}

/// Standard deviation 2.5 m ahead of b, by the surfaces that both share.
double expected_error_ahead_m(const SensorView& a, const SensorView& b,
                              const RigidTransform& a_from_b) {
  const auto partners = surface_partners(a.surface, b.surface, a_from_b, {kSettledReach_m, 6000});
  Matrix6 information = surface_equations(partners, a_from_b, surface_noise(partners))
                            .information.topLeftCorner<6, 6>();
  information += Matrix6::Identity();  // weak prior (1 m, 1 rad) for undetermined directions
  return expected_error_m(information, a_from_b * Eigen::Vector3d(0, 0, 2.5));
}

}  // namespace

Result<NudgedPose> refined_prior(const PairCandidates& pair, const RigidTransform& world_from_a,
                                 const RigidTransform& guess) {
  std::vector<RigidTransform> starts;
  for (const RigidTransform& start : starts_about(guess))
    starts.push_back(world_from_a.inverse() * start);
  const auto ends = refined_candidates(pair, starts);
  const PoseEvidence& best = ends.front();
  const Contradiction contradicts = contradiction(best);
  if (contradicts == Contradiction::kShapes) {
    return unavailable("its surfaces do not fit those of " + pair.a().name +
                       " there; bring it within 20 cm and 5 degrees");
  }
  if (contradicts == Contradiction::kColors)
    return unavailable("the surfaces fit there, but the colours do not");
  if (ends.size() > 1 && best.score - ends[1].score < kMinLead)
    return unavailable(
        "two poses near the guess fit equally well; bring it nearer to the right one");
  const RigidTransform world_from_depth = world_from_a * best.a_from_b;
  if (!is_near(world_from_depth, guess))
    return unavailable("the best fit is far from the guess; bring it nearer");
  return NudgedPose{world_from_depth,
                    1000 * expected_error_ahead_m(pair.a(), pair.b(), best.a_from_b),
                    pair.a().name};
}

Result<NudgedPose> refined_prior(const SensorView& view, const RigidTransform& guess,
                                 std::span<const PlacedView> others) {
  const auto partner = best_partner(view, guess, others);
  if (!partner)
    return unavailable(
        "there it has no overlap with a placed sensor, so the pose cannot be checked");
  return refined_prior(candidates_of(*partner->view, view), partner->world_from_depth, guess);
}

}  // namespace roomcast::alignment
