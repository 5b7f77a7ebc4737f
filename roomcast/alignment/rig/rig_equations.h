// SPDX-License-Identifier: Apache-2.0
// Normal equations of a whole rig, assembled from those of its pairs. Metres, radians, pixels.
// Single-threaded.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/rig/rig_scatter.h"

namespace roomcast::alignment {

/// Unknowns of each sensor: motion, then correction.
inline constexpr Eigen::Index kSensorUnknowns = 6 + kCorrectionUnknowns;

/// Matrix from both sensors' unknowns to the pair's: the pair's motion is the difference of theirs,
/// in a's frame.
[[nodiscard]] Eigen::Matrix<double, kPairUnknowns, 2 * kSensorUnknowns> pair_from_sensors(
    const RigidTransform& origin_from_a);

class RigEquations {
 public:
  /// The origin's pose is fixed, its calibration is not.
  RigEquations(std::size_t sensors, std::size_t origin);

  /// Adds the equations of a_from_b of sensors a and b.
  void add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
           const PairEquations& equations);

  /// Adds the prior of a sensor's calibration, at its current correction.
  void add_prior(std::size_t sensor, const SensorCorrection& correction,
                 const ColorShiftOptions& shift = {});

  /// Lets the depth scale of a sensor be solved for, with a normal prior around no error; `error`
  /// is the current one. The origin's stays fixed, because all others are relative to it.
  void free_depth_scale(std::size_t sensor, double error, double sigma);

  /// Of the scales that are free; 0 of the others.
  [[nodiscard]] std::vector<double> depth_scale_variances() const;

  /// One vector of kSensorUnknowns for each sensor. Unconstrained sensors do not move; depth is
  /// fixed, except for scales that are free.
  [[nodiscard]] std::vector<Eigen::Matrix<double, kSensorUnknowns, 1>> solve() const;

  /// Covariance of each sensor's motion, from random noise, smooth errors and depth errors that no
  /// view reveals; 0 for the origin and for unconstrained sensors.
  [[nodiscard]] std::vector<Matrix6> motion_covariance(const RigScatter& scatter,
                                                       const DepthUncertainty& doubt) const;

 private:
  [[nodiscard]] Eigen::MatrixXd anchored() const;
  /// Variance of the sum of all scores, caused by the depth errors of `doubt`.
  [[nodiscard]] Eigen::MatrixXd variance_by_depth(const DepthUncertainty& doubt) const;

  std::size_t sensors_, origin_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
  std::vector<bool> has_free_scale_;
};

}  // namespace roomcast::alignment
