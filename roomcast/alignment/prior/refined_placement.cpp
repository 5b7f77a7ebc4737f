// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/refined_placement.h"

#include <array>
#include <cmath>

#include <Eigen/LU>

#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

const Eigen::Vector3d kAhead_m(0, 0, 2.5);

/// The motion that takes one pose to another (step_transform).
Vector6 motion_between(const RigidTransform& from, const RigidTransform& to) {
  const Eigen::Matrix3d turn = to.rotation * from.rotation.transpose();
  Vector6 motion;
  motion << vector_from_rotation(turn), to.translation_m - turn * from.translation_m;
  return motion;
}

/// Information matrix of an estimated pose with this error.
Matrix6 information_of(double sigma_m, double walk_radius_m, const Eigen::Vector3d& ahead_m) {
  const Eigen::Matrix<double, 3, 6> by = point_motion(ahead_m);
  const double weight = 1 / (sigma_m * sigma_m);
  Matrix6 information = weight * by.transpose() * by;
  information.diagonal().head<3>().array() += weight * walk_radius_m * walk_radius_m;
  return information;
}

/// Standard deviation of a moved point.
double point_error_m(const Matrix6& covariance, const Eigen::Vector3d& point_m) {
  const Eigen::Matrix<double, 3, 6> by = point_motion(point_m);
  return std::sqrt((by * covariance * by.transpose()).trace());
}

/// The pose of b by the surfaces that both see; its covariance is 0 if they determine nothing.
RefinedSensor by_what_both_see(const PairCandidates& pair, const RigidTransform& start,
                               const RigOptions& rig) {
  const PairState settled =
      refined_pose(pair.a(), pair.b(), pair.matches(), start, ColorCalibration::kAsCalibrated,
                   rig.pair.refinement, rig.pair.residuals);
  const std::array poses = {RigidTransform(), settled.a_from_b};
  const std::array pairs = {RigPair{0, 1, &pair}};
  return refine_rig(poses, 0, pairs, rig.refinement, rig.pair.residuals)[1];
}

}  // namespace

std::optional<EstimatedPlacement> refined_placement(const SensorView& view,
                                                    const EstimatedPlacement& found,
                                                    std::span<const PlacedView> placed,
                                                    const RefinedPlacementOptions& options,
                                                    const RigOptions& rig) {
  const auto partner =
      best_partner(view, found.world_from_depth, placed, options.evidence, rig.pair.free_space);
  if (!partner) return std::nullopt;
  const PairCandidates pair = candidates_of(*partner->view, view, rig.pair);
  const RigidTransform at_first = partner->world_from_depth.inverse() * found.world_from_depth;
  const RefinedSensor shared = by_what_both_see(pair, at_first, rig);
  if (shared.covariance.isZero()) return std::nullopt;

  const double sigma_m = 0.001 * found.expected_error_mm;
  const Matrix6 before =
      information_of(sigma_m, options.walk_radius_m, shared.origin_from_sensor * kAhead_m);
  const Matrix6 by_surfaces = inverse_of(shared.weighed_covariance);
  const Matrix6 together = before + by_surfaces;
  const Vector6 back = motion_between(shared.origin_from_sensor, at_first);
  const RigidTransform a_from_b =
      step_transform(solve_symmetric(together, before * back)) * shared.origin_from_sensor;

  const PoseDifference apart = difference(a_from_b, at_first, kAhead_m);
  if (apart.distance_m > options.max_sigmas * sigma_m ||
      apart.angle_rad * options.walk_radius_m > options.max_sigmas * sigma_m) {
    return std::nullopt;
  }
  if (contradiction(pair.examine(a_from_b), options.evidence) != Contradiction::kNone)
    return std::nullopt;
  // Of the mean, when surfaces err as is said of them.
  const Matrix6 variance = before + by_surfaces * shared.covariance * by_surfaces;
  const Matrix6 covariance = inverse_of(together) * variance * inverse_of(together);
  return EstimatedPlacement{partner->world_from_depth * a_from_b,
                            1000 * point_error_m(covariance, a_from_b * kAhead_m)};
}

}  // namespace roomcast::alignment
