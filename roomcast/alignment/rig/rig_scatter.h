// SPDX-License-Identifier: Apache-2.0
// Effect of all sensors' smooth errors on a rig's equations: the scores (sums of w J^T r) of every
// patch of every sensor's picture, over all pairs of that sensor. Their spread, propagated through
// the equations, gives the uncertainty of the poses (the sandwich of Huber 1967; by clusters, Liang
// & Zeger 1986). Metres, radians, pixels. Single-threaded.
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

  /// Adds the scores of a_from_b of sensors a and b.
  void add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
           const PairScores& scores);

  /// Variance of the sum of all scores; its unknowns are those of RigEquations.
  [[nodiscard]] Eigen::MatrixXd variance() const;

  /// Smooth disagreement of surfaces: RMS of the patches' mean residuals, metres.
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
