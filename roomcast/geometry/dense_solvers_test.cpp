// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/dense_solvers.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

Eigen::MatrixXd some_symmetric() {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 4, 1, -1, 1, 3, 0.5, -1, 0.5, 2;
  return matrix;
}

TEST(DenseSolvers, a_symmetric_system_is_solved_for_several_right_sides) {
  const Eigen::MatrixXd unknown = Eigen::MatrixXd::Random(3, 2);
  EXPECT_TRUE(solve_symmetric(some_symmetric(), some_symmetric() * unknown).isApprox(unknown));
}

TEST(DenseSolvers, directions_without_information_stay_zero) {
  Eigen::MatrixXd flat = Eigen::MatrixXd::Zero(2, 2);
  flat(0, 0) = 2;
  EXPECT_EQ(solve_symmetric(flat, Eigen::Vector2d(4, 0)), Eigen::Vector2d(2, 0));
}

TEST(DenseSolvers, a_matrix_times_its_inverse_is_the_identity) {
  EXPECT_TRUE((some_symmetric() * inverse_of(some_symmetric())).isIdentity(1e-12));
}

TEST(DenseSolvers, a_singular_matrix_has_no_finite_inverse) {
  EXPECT_FALSE(inverse_of(Eigen::MatrixXd::Zero(6, 6)).allFinite());
}

TEST(DenseSolvers, principal_axes_rebuild_their_matrix) {
  const PrincipalAxes axes = principal_axes(some_symmetric());
  EXPECT_LT(axes.variances(0), axes.variances(2));
  EXPECT_TRUE((axes.directions * axes.variances.asDiagonal() * axes.directions.transpose())
                  .isApprox(some_symmetric()));
}

TEST(DenseSolvers, a_plane_is_thinnest_along_its_normal) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, -2) / 3;
  const Eigen::Matrix3d moments = Eigen::Matrix3d::Identity() - 0.9 * normal * normal.transpose();
  EXPECT_NEAR(std::abs(thinnest_direction(moments).dot(normal)), 1, 1e-12);
}

}  // namespace
}  // namespace roomcast
