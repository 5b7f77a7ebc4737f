// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pose_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::alignment {
namespace {

constexpr double kRivalAngle_rad = 4 * std::numbers::pi / 180;
constexpr double kRivalDistance_m = 0.2;

}  // namespace

PoseDifference difference(const RigidTransform& one, const RigidTransform& other,
                          const Eigen::Vector3d& at_m) {
  const Eigen::Matrix3d turn = one.rotation.transpose() * other.rotation;
  const double sine = (turn - Eigen::Matrix3d::Identity()).norm() / (2 * std::numbers::sqrt2);
  return {2 * std::asin(std::clamp(sine, 0.0, 1.0)), (one * at_m - other * at_m).norm()};
}

bool are_rivals(const RigidTransform& one, const RigidTransform& other) {
  const PoseDifference apart = difference(one, other);
  return apart.angle_rad > kRivalAngle_rad || apart.distance_m > kRivalDistance_m;
}

}  // namespace roomcast::alignment
