// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/color_balance.h"

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast {

Eigen::MatrixXd log_gains(std::span<const ColorRatio> ratios, std::size_t cameras,
                          double prior_places) {
  const auto count = static_cast<Eigen::Index>(cameras);
  Eigen::MatrixXd normal = prior_places * Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
  for (const ColorRatio& ratio : ratios) {
    const auto a = static_cast<Eigen::Index>(ratio.a), b = static_cast<Eigen::Index>(ratio.b);
    // Equation: gain_a * a = gain_b * b.
    normal(a, a) += ratio.places;
    normal(b, b) += ratio.places;
    normal(a, b) -= ratio.places;
    normal(b, a) -= ratio.places;
    right.row(a) += ratio.places * ratio.log_b_over_a.transpose();
    right.row(b) -= ratio.places * ratio.log_b_over_a.transpose();
  }
  return solve_symmetric(normal, right);
}

}  // namespace roomcast
