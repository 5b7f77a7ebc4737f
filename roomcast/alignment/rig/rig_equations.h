// SPDX-License-Identifier: Apache-2.0
// The normal equations of a whole rig, put together from those of its pairs. Metres, radians,
// pixels. Single-threaded.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/rig/rig_scatter.h"

namespace roomcast::alignment {

/// Of each sensor: motion, then correction.
inline constexpr Eigen::Index kSensorUnknowns = 6 + kCorrectionUnknowns;

/// A pair's unknowns from both sensors' own: its motion is the difference of theirs, seen from a.
[[nodiscard]] Eigen::Matrix<double, kPairUnknowns, 2 * kSensorUnknowns> pair_from_sensors(
    const RigidTransform& origin_from_a);

class RigEquations {
 public:
  /// The origin's pose is held, its calibration is not.
  RigEquations(std::size_t sensors, std::size_t origin);

  /// `equations` are about a_from_b of sensors a and b.
  void add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
           const PairEquations& equations);

  /// What is expected of a sensor's calibration, at what it is thought to be off by.
  void add_expectation(std::size_t sensor, const SensorCorrection& correction);

  /// One vector of kSensorUnknowns for each sensor; those that nothing holds do not move, and
  /// depth is left as it is.
  [[nodiscard]] std::vector<Eigen::Matrix<double, kSensorUnknowns, 1>> solve() const;

  /// How far off the sensors' motions may be: by random noise, by smooth errors, and by what depth
  /// is expected to be off by, which no view tells.
  [[nodiscard]] std::vector<Matrix6> motion_covariance(const RigScatter& scatter,
                                                       const DepthDoubt& doubt) const;

 private:
  [[nodiscard]] Eigen::MatrixXd anchored() const;
  /// Of the sum of all scores, if depth is off by as much as is doubted.
  [[nodiscard]] Eigen::MatrixXd variance_by_depth(const DepthDoubt& doubt) const;

  std::size_t sensors_, origin_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

}  // namespace roomcast::alignment
