// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_scatter.h"

#include <cmath>

#include "roomcast/alignment/rig/rig_equations.h"

namespace roomcast::alignment {

void RigScatter::add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
                     const PairScores& scores) {
  const Eigen::MatrixXd carry = pair_from_sensors(origin_from_a);
  add(a, scores.of_a, a, b, carry);
  add(b, scores.of_b, a, b, carry);
}

void RigScatter::add(std::size_t sensor, const PatchScores& scores, std::size_t a, std::size_t b,
                     const Eigen::MatrixXd& carry) {
  constexpr Eigen::Index kN = kSensorUnknowns;
  for (const auto& [patch, of_patch] : scores) {
    Sum& sum = patches_[{sensor, patch}];
    if (sum.score.size() == 0) sum.score.setZero(kN * static_cast<Eigen::Index>(sensors_));
    const Eigen::VectorXd score = carry.transpose() * of_patch.score;
    sum.score.segment<kN>(kN * static_cast<Eigen::Index>(a)) += score.head<kN>();
    sum.score.segment<kN>(kN * static_cast<Eigen::Index>(b)) += score.tail<kN>();
    sum.weight += of_patch.weight;
    sum.residual += of_patch.residual;
  }
}

/// Every term is in a patch of each sensor, so each counts half.
Eigen::MatrixXd RigScatter::variance() const {
  const Eigen::Index size = kSensorUnknowns * static_cast<Eigen::Index>(sensors_);
  Eigen::MatrixXd variance = Eigen::MatrixXd::Zero(size, size);
  for (const auto& [place, sum] : patches_) variance += 0.5 * sum.score * sum.score.transpose();
  return variance;
}

double RigScatter::disagreement_m() const {
  double squares = 0, weight = 0;
  for (const auto& [place, sum] : patches_) {
    if (!(sum.weight > 0)) continue;
    squares += sum.residual * sum.residual / sum.weight;
    weight += sum.weight;
  }
  return weight > 0 ? std::sqrt(squares / weight) : 0;
}

}  // namespace roomcast::alignment
