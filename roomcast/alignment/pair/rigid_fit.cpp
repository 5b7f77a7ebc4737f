// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/rigid_fit.h"

#include <Eigen/Dense>

namespace roomcast::alignment {
namespace {

constexpr double kFlattest =
    1e-4;  // share of the largest singular value: below it the points are on a line

}  // namespace

std::optional<RigidTransform> fit_a_from_b(std::span<const PointMatch> matches,
                                           std::span<const float> weights) {
  Eigen::Vector3d mean_a = Eigen::Vector3d::Zero(), mean_b = Eigen::Vector3d::Zero();
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    mean_a += double(weights[i]) * matches[i].a_m.cast<double>();
    mean_b += double(weights[i]) * matches[i].b_m.cast<double>();
    sum += double(weights[i]);
    ++count;
  }
  if (count < 3) return std::nullopt;
  mean_a /= sum;
  mean_b /= sum;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    moments += double(weights[i]) * (matches[i].b_m.cast<double>() - mean_b) *
               (matches[i].a_m.cast<double>() - mean_a).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()(1) > kFlattest * svd.singularValues()(0))) return std::nullopt;
  const Eigen::Matrix3d& u = svd.matrixU();
  const Eigen::Matrix3d& v = svd.matrixV();
  const double handedness = (v * u.transpose()).determinant() < 0 ? -1 : 1;
  RigidTransform a_from_b;
  a_from_b.rotation = v * Eigen::Vector3d(1, 1, handedness).asDiagonal() * u.transpose();
  a_from_b.translation_m = mean_a - a_from_b.rotation * mean_b;
  return a_from_b;
}

}  // namespace roomcast::alignment
