// SPDX-License-Identifier: Apache-2.0
// Normal equations of a Gauss-Newton step for a pair of sensors. The unknowns are the motion xi =
// (rotation, shift), applied on the left: a_from_b <- exp(xi) a_from_b, and the calibration errors
// of both sensors. Radians, metres, pixels. Thread-safe (no state).
#pragma once

#include <Eigen/Core>

#include "roomcast/alignment/pair/sensor_correction.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Indices of the unknowns.
inline constexpr Eigen::Index kMotion = 0, kOfA = 6, kOfB = kOfA + kCorrectionUnknowns;
inline constexpr Eigen::Index kPairUnknowns = kOfB + kCorrectionUnknowns;
/// Indices within one sensor's correction.
inline constexpr Eigen::Index kShift = 0, kDepth = 2;

using PairVector = Eigen::Matrix<double, kPairUnknowns, 1>;
using PairMatrix = Eigen::Matrix<double, kPairUnknowns, kPairUnknowns>;

/// Relative pose of a pair and its sensors' calibration corrections.
struct PairState {
  RigidTransform a_from_b;
  SensorCorrection a, b;
};

struct PairEquations {
  PairMatrix information = PairMatrix::Zero();  // sum of w J^T J
  PairVector gradient = PairVector::Zero();     // sum of w J^T r
  int terms = 0;

  void add(const PairVector& jacobian, double residual, double weight) {
    information.noalias() += weight * jacobian * jacobian.transpose();
    gradient.noalias() += weight * residual * jacobian;
    ++terms;
  }
  void add(const PairEquations& other, double factor = 1) {
    information += factor * other.information;
    gradient += factor * other.gradient;
    terms += other.terms;
  }
};

/// exp(xi) for the small steps of an iteration; the rotation is exact, the shift is taken as it is.
[[nodiscard]] RigidTransform step_transform(const Vector6& xi);

/// Derivative of a point by the motion.
[[nodiscard]] Eigen::Matrix<double, 3, 6> point_motion(const Eigen::Vector3d& point_m);

/// Standard deviation, metres, of a moved point, given the information on the motion.
[[nodiscard]] double expected_error_m(const Matrix6& information, const Eigen::Vector3d& point_m);

/// The motion that solves the equations with fixed calibrations; zero where they constrain nothing.
[[nodiscard]] Vector6 solve_motion(const PairEquations& equations);

/// One step of motion and colour corrections; depth stays fixed.
[[nodiscard]] PairVector solve_state(PairEquations equations, const PairState& at,
                                     const ColorShiftOptions& shift = {});
void move(const PairVector& step, PairState& state);

/// Weight of a residual (in sigmas) that may be an outlier: Geman & McClure 1985.
[[nodiscard]] inline double robust_weight(double sigmas) {
  const double part = 1 + sigmas * sigmas / 4;
  return 1 / (part * part);
}

}  // namespace roomcast::alignment
