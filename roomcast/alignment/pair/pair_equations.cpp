// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pair_equations.h"

#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

constexpr double kMinTrace = 1e-6;
constexpr double kDamping = 1e-9;  // share of the trace: unconstrained unknowns do not move
constexpr double kHeld = 1e12;     // information on fixed unknowns

void add_prior(const SensorCorrection& correction, Eigen::Index first,
               const ColorShiftOptions& shift, PairEquations& equations) {
  const double weight = shift_prior_weight(correction.color_shift_px, shift);
  equations.information.diagonal().segment<2>(first + kShift).array() += weight;
  equations.gradient.segment<2>(first + kShift) += weight * correction.color_shift_px;
}

}  // namespace

RigidTransform step_transform(const Vector6& xi) {
  return {rotation_from_vector(xi.head<3>()), xi.tail<3>()};
}

Eigen::Matrix<double, 3, 6> point_motion(const Eigen::Vector3d& point_m) {
  Eigen::Matrix<double, 3, 6> by;
  for (int axis = 0; axis < 3; ++axis) by.col(axis) = Eigen::Vector3d::Unit(axis).cross(point_m);
  by.rightCols<3>().setIdentity();
  return by;
}

double expected_error_m(const Matrix6& information, const Eigen::Vector3d& point_m) {
  const Eigen::Matrix<double, 3, 6> by = point_motion(point_m);
  return std::sqrt((by * Matrix6(inverse_of(information)) * by.transpose()).trace());
}

Vector6 solve_motion(const PairEquations& equations) {
  Matrix6 information = equations.information.topLeftCorner<6, 6>();
  const double trace = information.trace();
  if (!(trace > kMinTrace)) return Vector6::Zero();
  information.diagonal().array() += kDamping * trace;
  return solve_symmetric(information, -equations.gradient.head<6>());
}

PairVector solve_state(PairEquations equations, const PairState& at,
                       const ColorShiftOptions& shift) {
  const double trace = equations.information.topLeftCorner<6, 6>().trace();
  if (!(trace > kMinTrace)) return PairVector::Zero();
  add_prior(at.a, kOfA, shift, equations);
  add_prior(at.b, kOfB, shift, equations);
  equations.information.diagonal().head<6>().array() += kDamping * trace;
  for (const Eigen::Index of : {kOfA, kOfB})
    equations.information.diagonal().segment<2>(of + kDepth).array() += kHeld;
  return solve_symmetric(equations.information, -equations.gradient);
}

void move(const PairVector& step, PairState& state) {
  state.a_from_b = step_transform(step.head<6>()) * state.a_from_b;
  state.a.color_shift_px += step.segment<2>(kOfA + kShift);
  state.b.color_shift_px += step.segment<2>(kOfB + kShift);
}

}  // namespace roomcast::alignment
