// SPDX-License-Identifier: Apache-2.0
// The normal equations of a whole rig, put together from those of its pairs. Metres, radians,
// pixels. Single-threaded.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "roomcast/align/pair/pair_equations.h"

namespace roomcast::align {

/// Of each sensor: motion, then correction.
inline constexpr Eigen::Index kSensorUnknowns = 6 + kCorrectionUnknowns;

class RigEquations {
 public:
  /// The origin's pose is held, its calibration is not.
  RigEquations(std::size_t sensors, std::size_t origin);

  /// `equations` are about a_from_b of sensors a and b.
  void add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
           const PairEquations& equations);

  /// What is expected of a sensor's calibration. Most colour cameras are good to a pixel, but one
  /// that is not may be off by any amount (Cauchy's distribution, weighted anew at what it is
  /// thought to be off by); depth is off by a little (Gauss's).
  void add_expectation(std::size_t sensor, const SensorCorrection& correction);

  /// One vector of kSensorUnknowns for each sensor; those that nothing holds do not move, and
  /// depth is left as it is.
  [[nodiscard]] std::vector<Eigen::Matrix<double, kSensorUnknowns, 1>> solve() const;

  /// Of the sensors' motions, with depth in doubt.
  [[nodiscard]] std::vector<Matrix6> motion_covariance() const;

 private:
  [[nodiscard]] Eigen::MatrixXd anchored() const;

  std::size_t sensors_, origin_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

}  // namespace roomcast::align
