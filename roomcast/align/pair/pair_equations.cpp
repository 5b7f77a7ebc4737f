// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/pair_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace roomcast::align {
namespace {

constexpr double kLeastTrace = 1e-6;
constexpr double kDamping = 1e-9;  // of the trace: what nothing holds on to stays where it is

}  // namespace

RigidTransform step_transform(const Vector6& xi) {
  const double angle = xi.head<3>().norm();
  RigidTransform step;
  if (angle > 0) {
    step.rotation = Eigen::AngleAxisd(angle, xi.head<3>() / angle).toRotationMatrix();
  }
  step.translation_m = xi.tail<3>();
  return step;
}

Vector6 solve_motion(const PairEquations& equations) {
  Matrix6 information = equations.information.topLeftCorner<6, 6>();
  const double trace = information.trace();
  if (!(trace > kLeastTrace)) return Vector6::Zero();
  information.diagonal().array() += kDamping * trace;
  return information.ldlt().solve(-equations.gradient.head<6>());
}

}  // namespace roomcast::align
