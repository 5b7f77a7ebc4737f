// SPDX-License-Identifier: Apache-2.0
#include "bench/align/rig_error.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "roomcast/core/assert.h"

namespace roomcast::bench {
namespace {

/// The rotation nearest to the mean of all (chordal; Hartley et al. 2013).
Eigen::Matrix3d mean_rotation(std::span<const RigidTransform> transforms) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const RigidTransform& transform : transforms) sum += transform.rotation;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

double angle_deg(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return Eigen::AngleAxisd(one.transpose() * other).angle() * 180 / std::numbers::pi;
}

}  // namespace

RigError rig_error(std::span<const RigidTransform> truth, std::span<const RigidTransform> found,
                   const Eigen::Vector3d& middle_m) {
  ROOMCAST_ASSERT(truth.size() == found.size());
  std::vector<RigidTransform> found_from_truth;
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    found_from_truth.push_back(found[i] * truth[i].inverse());
    mean_m += found_from_truth.back() * middle_m / static_cast<double>(truth.size());
  }
  const Eigen::Matrix3d mean = mean_rotation(found_from_truth);
  RigError worst;
  for (const RigidTransform& each : found_from_truth) {
    const RigidTransform& first = found_from_truth.front();
    const Eigen::Vector3d put_m = each * middle_m;
    worst.from_all_mm = std::max(worst.from_all_mm, 1000 * (put_m - mean_m).norm());
    worst.from_all_deg = std::max(worst.from_all_deg, angle_deg(mean, each.rotation));
    worst.from_first_mm = std::max(worst.from_first_mm, 1000 * (put_m - first * middle_m).norm());
    worst.from_first_deg = std::max(worst.from_first_deg, angle_deg(first.rotation, each.rotation));
  }
  return worst;
}

}  // namespace roomcast::bench
