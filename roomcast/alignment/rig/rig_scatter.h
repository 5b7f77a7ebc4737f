// SPDX-License-Identifier: Apache-2.0
// What the smooth errors of all sensors do to a rig's equations: the scores (sums of w J^T r) of
// every patch of every sensor's picture, over all pairs that it takes part in. Their spread, seen
// through the equations, is how far off the poses may be (the sandwich of Huber 1967; by clusters,
// Liang & Zeger 1986). Metres, radians, pixels. Single-threaded.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include <Eigen/Core>

#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

class RigScatter {
 public:
  explicit RigScatter(std::size_t sensors) : sensors_(sensors) {}

  /// `scores` are about a_from_b of sensors a and b.
  void add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
           const PairScores& scores);

  /// Variance of the sum of all scores; its unknowns are those of RigEquations.
  [[nodiscard]] Eigen::MatrixXd variance() const;

  /// By how much surfaces disagree smoothly: the patches' mean residuals (RMS), in metres.
  [[nodiscard]] double disagreement_m() const;

 private:
  struct Sum {
    Eigen::VectorXd score;
    double weight = 0, residual = 0;
  };
  void add(std::size_t sensor, const PatchScores& scores, std::size_t a, std::size_t b,
           const Eigen::MatrixXd& carry);

  std::size_t sensors_;
  std::map<std::pair<std::size_t, int>, Sum> patches_;  // by sensor and patch
};

}  // namespace roomcast::alignment
