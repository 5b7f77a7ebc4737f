// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rotations.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace roomcast {
namespace {

using Eigen::Vector3d;

TEST(Rotations, about_an_axis_of_any_length) {
  const Eigen::Matrix3d quarter = rotation_about(Vector3d(0, 0, 3), std::numbers::pi / 2);
  EXPECT_LT((quarter * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_TRUE(rotation_about(Vector3d::Zero(), 1).isIdentity());
}

TEST(Rotations, vectors_and_matrices_describe_the_same_rotation) {
  const Vector3d vector(0.3, -1.2, 0.4);
  EXPECT_LT((vector_from_rotation(rotation_from_vector(vector)) - vector).norm(), 1e-14);
  EXPECT_TRUE(rotation_from_vector(Vector3d::Zero()).isIdentity());
  EXPECT_LT(vector_from_rotation(Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(Rotations, one_direction_turns_into_another_by_the_smallest_angle) {
  const Vector3d from(0.1, 2, -0.3), to(-1, 0.5, 0.7);
  const Eigen::Matrix3d turn = rotation_between(from, to);
  EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-14);
  EXPECT_NEAR(vector_from_rotation(turn).norm(), std::acos(from.normalized().dot(to.normalized())),
              1e-12);
  EXPECT_TRUE(rotation_between(from, 4 * from).isIdentity(1e-14));
}

TEST(Rotations, opposite_directions_are_half_a_turn_apart) {
  const Vector3d from(0.1, 2, -0.3);
  const Eigen::Matrix3d turn = rotation_between(from, -from);
  EXPECT_LT((turn * from + from).norm(), 1e-12);
  EXPECT_NEAR(turn.determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace roomcast
