// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pose_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::alignment {

PoseDifference difference(const RigidTransform& one, const RigidTransform& other,
                          const Eigen::Vector3d& at_m) {
  const Eigen::Matrix3d turn = one.rotation.transpose() * other.rotation;
  const double sine = (turn - Eigen::Matrix3d::Identity()).norm() / (2 * std::numbers::sqrt2);
  return {2 * std::asin(std::clamp(sine, 0.0, 1.0)), (one * at_m - other * at_m).norm()};
}

bool are_rivals(const RigidTransform& one, const RigidTransform& other,
                const RivalOptions& options) {
  const PoseDifference apart = difference(one, other);
  return apart.angle_rad > options.angle_rad || apart.distance_m > options.distance_m;
}

}  // namespace roomcast::alignment
