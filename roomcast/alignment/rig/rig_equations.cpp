// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_equations.h"

#include <limits>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

constexpr double kDamping = 1e-10;       // share of the trace: unconstrained unknowns do not move
constexpr double kHeld = 1e12;           // information on fixed unknowns
constexpr Eigen::Index kCorrection = 6;  // index among a sensor's unknowns

Matrix6 adjoint(const RigidTransform& transform) {
  const Eigen::Vector3d& t = transform.translation_m;
  Eigen::Matrix3d cross;
  cross << 0, -t.z(), t.y(), t.z(), 0, -t.x(), -t.y(), t.x(), 0;
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = transform.rotation;
  out.bottomRightCorner<3, 3>() = transform.rotation;
  out.bottomLeftCorner<3, 3>() = cross * transform.rotation;
  return out;
}

Eigen::Index place(std::size_t sensor) {
  return kSensorUnknowns * static_cast<Eigen::Index>(sensor);
}

}  // namespace

Eigen::Matrix<double, kPairUnknowns, 2 * kSensorUnknowns> pair_from_sensors(
    const RigidTransform& origin_from_a) {
  Eigen::Matrix<double, kPairUnknowns, 2 * kSensorUnknowns> matrix;
  matrix.setZero();
  const Matrix6 carry = adjoint(origin_from_a.inverse());
  matrix.block<6, 6>(kMotion, 0) = -carry;
  matrix.block<6, 6>(kMotion, kSensorUnknowns) = carry;
  constexpr Eigen::Index kN = kCorrectionUnknowns;
  matrix.block<kN, kN>(kOfA, kCorrection).setIdentity();
  matrix.block<kN, kN>(kOfB, kSensorUnknowns + kCorrection).setIdentity();
  return matrix;
}

RigEquations::RigEquations(std::size_t sensors, std::size_t origin)
    : sensors_(sensors),
      origin_(origin),
      information_(Eigen::MatrixXd::Zero(place(sensors), place(sensors))),
      gradient_(Eigen::VectorXd::Zero(place(sensors))),
      has_free_scale_(sensors) {}

void RigEquations::add(std::size_t a, std::size_t b, const RigidTransform& origin_from_a,
                       const PairEquations& equations) {
  const Eigen::MatrixXd carry = pair_from_sensors(origin_from_a);
  const Eigen::MatrixXd of_pair = equations.information;
  const Eigen::MatrixXd information = carry.transpose() * of_pair * carry;
  const Eigen::VectorXd gradient = carry.transpose() * equations.gradient;
  constexpr Eigen::Index kN = kSensorUnknowns;
  information_.block<kN, kN>(place(a), place(a)) += information.topLeftCorner<kN, kN>();
  information_.block<kN, kN>(place(a), place(b)) += information.topRightCorner<kN, kN>();
  information_.block<kN, kN>(place(b), place(a)) += information.bottomLeftCorner<kN, kN>();
  information_.block<kN, kN>(place(b), place(b)) += information.bottomRightCorner<kN, kN>();
  gradient_.segment<kN>(place(a)) += gradient.head<kN>();
  gradient_.segment<kN>(place(b)) += gradient.tail<kN>();
}

void RigEquations::add_prior(std::size_t sensor, const SensorCorrection& correction,
                             const ColorShiftOptions& shift) {
  const Eigen::Index first = place(sensor) + kCorrection;
  const Eigen::Vector2d& shift_px = correction.color_shift_px;
  const double shift_weight = shift_prior_weight(shift_px, shift);
  information_.diagonal().segment<2>(first + kShift).array() += shift_weight;
  gradient_.segment<2>(first + kShift) += shift_weight * shift_px;
}

void RigEquations::free_depth_scale(std::size_t sensor, double error, double sigma) {
  if (sensor == origin_) return;
  const Eigen::Index scale = place(sensor) + kCorrection + kDepth + 1;
  has_free_scale_[sensor] = true;
  information_(scale, scale) += 1 / (sigma * sigma);
  gradient_(scale) += error / (sigma * sigma);
}

std::vector<double> RigEquations::depth_scale_variances() const {
  const Eigen::MatrixXd covariance =
      solve_symmetric(anchored(), Eigen::MatrixXd::Identity(place(sensors_), place(sensors_)));
  std::vector<double> variances(sensors_);
  for (std::size_t i = 0; i < sensors_; ++i) {
    const Eigen::Index scale = place(i) + kCorrection + kDepth + 1;
    if (has_free_scale_[i]) variances[i] = covariance(scale, scale);
  }
  return variances;
}

Eigen::MatrixXd RigEquations::anchored() const {
  Eigen::MatrixXd matrix = information_;
  matrix.diagonal().array() += kDamping * information_.trace() + std::numeric_limits<double>::min();
  matrix.block<6, 6>(place(origin_), place(origin_)).diagonal().array() += kHeld;
  for (std::size_t i = 0; i < sensors_; ++i)
    matrix.diagonal()
        .segment(place(i) + kCorrection + kDepth, has_free_scale_[i] ? 1 : 2)
        .array() += kHeld;
  return matrix;
}

std::vector<Eigen::Matrix<double, kSensorUnknowns, 1>> RigEquations::solve() const {
  const Eigen::VectorXd steps = solve_symmetric(anchored(), -gradient_);
  std::vector<Eigen::Matrix<double, kSensorUnknowns, 1>> of_sensors;
  for (std::size_t i = 0; i < sensors_; ++i) {
    of_sensors.emplace_back(steps.segment<kSensorUnknowns>(place(i)));
  }
  return of_sensors;
}

Eigen::MatrixXd RigEquations::variance_by_depth(const DepthUncertainty& doubt) const {
  Eigen::MatrixXd variance = Eigen::MatrixXd::Zero(place(sensors_), place(sensors_));
  Eigen::VectorXd by_common_scale = Eigen::VectorXd::Zero(place(sensors_));
  for (std::size_t i = 0; i < sensors_; ++i) {
    const Eigen::Index depth = place(i) + kCorrection + kDepth;
    const Eigen::VectorXd by_offset = doubt.offset_m * information_.col(depth);
    const Eigen::VectorXd by_scale = doubt.scale * information_.col(depth + 1);
    variance += by_offset * by_offset.transpose() + by_scale * by_scale.transpose();
    by_common_scale += doubt.common_scale * information_.col(depth + 1);
  }
  variance += by_common_scale * by_common_scale.transpose();
  return variance;
}

std::vector<Matrix6> RigEquations::motion_covariance(const RigScatter& scatter,
                                                     const DepthUncertainty& doubt) const {
  const Eigen::MatrixXd random =
      solve_symmetric(anchored(), Eigen::MatrixXd::Identity(place(sensors_), place(sensors_)));
  const Eigen::MatrixXd by_readings = scatter.variance() + variance_by_depth(doubt);
  const Eigen::MatrixXd all = random + random * by_readings * random;
  std::vector<Matrix6> of_sensors;
  for (std::size_t i = 0; i < sensors_; ++i) {
    const Eigen::Index k = place(i);
    const bool held = i != origin_ && information_.block<6, 6>(k, k).trace() > 0;
    of_sensors.push_back(held ? Matrix6(all.block<6, 6>(k, k)) : Matrix6::Zero());
  }
  return of_sensors;
}

}  // namespace roomcast::alignment
