// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rigid_transform.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace roomcast {
namespace {

using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

constexpr double kRotationTolerance = 1e-3;  // of any element of R^T R, against the identity
constexpr double kLastRowTolerance = 1e-9;
constexpr double kNearlyVertical = 1e-6;  // sine of the angle between view and world y

Error malformed(const char* message) {
  return {ErrorCode::kMalformed, message};
}

bool is_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d product = matrix.transpose() * matrix;
  return (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRotationTolerance &&
         matrix.determinant() > 0;
}

/// The nearest rotation in the Frobenius norm (orthogonal Procrustes): the SVD without its singular
/// values.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

}  // namespace

RigidTransform RigidTransform::operator*(const RigidTransform& other) const {
  return {rotation * other.rotation, rotation * other.translation_m + translation_m};
}

RigidTransform RigidTransform::inverse() const {
  return {rotation.transpose(), -(rotation.transpose() * translation_m)};
}

std::array<double, 16> row_major_from_transform(const RigidTransform& transform) {
  RowMajor4 matrix = RowMajor4::Identity();
  matrix.topLeftCorner<3, 3>() = transform.rotation;
  matrix.topRightCorner<3, 1>() = transform.translation_m;
  std::array<double, 16> numbers;
  std::copy_n(matrix.data(), numbers.size(), numbers.begin());
  return numbers;
}

Result<RigidTransform> transform_from_row_major(std::span<const double> row_major) {
  if (row_major.size() != 16) return malformed("a transform needs 16 numbers, row by row");
  if (!std::all_of(row_major.begin(), row_major.end(), [](double x) { return std::isfinite(x); })) {
    return malformed("a transform must consist of finite numbers");
  }
  const Eigen::Map<const RowMajor4> matrix(row_major.data());
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > kLastRowTolerance) {
    return malformed("the last row of a transform must be 0 0 0 1");
  }
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  if (!is_rotation(rotation)) {
    return malformed("the upper left 3x3 of a transform must be a rotation");
  }
  return RigidTransform{nearest_rotation(rotation), matrix.topRightCorner<3, 1>()};
}

RigidTransform exact_transform_from_row_major(std::span<const double, 16> row_major) {
  const Eigen::Map<const RowMajor4> matrix(row_major.data());
  return {matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
}

RigidTransform world_from_optical_looking_at(const Eigen::Vector3d& eye_m,
                                             const Eigen::Vector3d& target_m) {
  const Eigen::Vector3d forward = (target_m - eye_m).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY());
  if (right.norm() < kNearlyVertical) right = forward.cross(-Eigen::Vector3d::UnitZ());
  right.normalize();
  RigidTransform world_from_optical;
  world_from_optical.rotation << right, forward.cross(right), forward;
  world_from_optical.translation_m = eye_m;
  return world_from_optical;
}

}  // namespace roomcast
