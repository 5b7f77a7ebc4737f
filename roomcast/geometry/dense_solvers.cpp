// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/dense_solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace roomcast {

Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
  return matrix.inverse();
}

PrincipalAxes principal_axes(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(symmetric);
  return {axes.eigenvalues(), axes.eigenvectors()};
}

Eigen::Vector3d thinnest_direction(const Eigen::Matrix3d& moments) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
}

}  // namespace roomcast
