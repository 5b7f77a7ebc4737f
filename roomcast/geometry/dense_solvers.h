// SPDX-License-Identifier: Apache-2.0
// Decompositions of small dense matrices by Eigen, behind plain functions: each decomposition takes
// a compiler seconds for every size and in every unit that names it, so they are compiled here and
// only here.
#pragma once

#include <Eigen/Core>

namespace roomcast {

/// x with `matrix * x == right`, by LDL^T. `matrix` is symmetric and positive semidefinite (n x n),
/// `right` is n x k. The directions in which the matrix is singular stay 0.
[[nodiscard]] Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix,
                                              const Eigen::MatrixXd& right);

/// By LU. Of a singular matrix the result is not finite.
[[nodiscard]] Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);

/// Eigenvalues, ascending, and their unit eigenvectors (columns) of a symmetric matrix.
struct PrincipalAxes {
  Eigen::VectorXd variances;
  Eigen::MatrixXd directions;
};
[[nodiscard]] PrincipalAxes principal_axes(const Eigen::MatrixXd& symmetric);

/// The direction in which these centred moments of points (3 x 3) are thinnest: a plane's unit
/// normal.
[[nodiscard]] Eigen::Vector3d thinnest_direction(const Eigen::Matrix3d& moments);

}  // namespace roomcast
