// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rigid_transform.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast {
namespace {

using Eigen::Vector3d;

RigidTransform some_transform() {
  RigidTransform transform;
  transform.rotation = Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  transform.translation_m = Vector3d(0.3, -1.2, 4.5);
  return transform;
}

TEST(RigidTransform, inverse_undoes_it) {
  const RigidTransform a_from_b = some_transform();
  const Vector3d point(1.5, 2.5, -3.5);
  EXPECT_LT((a_from_b.inverse() * (a_from_b * point) - point).norm(), 1e-14);
}

TEST(RigidTransform, products_apply_right_to_left) {
  const RigidTransform a_from_b = some_transform();
  const RigidTransform b_from_c = some_transform().inverse() * some_transform() * some_transform();
  const Vector3d point(1.5, 2.5, -3.5);
  EXPECT_LT(((a_from_b * b_from_c) * point - a_from_b * (b_from_c * point)).norm(), 1e-14);
}

TEST(RigidTransform, row_major_round_trips) {
  const RigidTransform before = some_transform();
  const auto after = transform_from_row_major(row_major_from_transform(before));
  ASSERT_TRUE(after.ok());
  EXPECT_LT((after->rotation - before.rotation).norm(), 1e-14);
  EXPECT_EQ(after->translation_m, before.translation_m);
}

TEST(RigidTransform, translation_is_the_last_column_of_the_row_major_form) {
  const auto numbers = row_major_from_transform(some_transform());
  EXPECT_EQ(numbers[3], 0.3);
  EXPECT_EQ(numbers[7], -1.2);
  EXPECT_EQ(numbers[11], 4.5);
  EXPECT_EQ(numbers[15], 1.0);
}

TEST(RigidTransform, a_rounded_rotation_comes_back_orthonormal) {
  auto numbers = row_major_from_transform(some_transform());
  for (double& number : numbers) number = std::round(number * 1e4) / 1e4;
  const auto transform = transform_from_row_major(numbers);
  ASSERT_TRUE(transform.ok());
  const Eigen::Matrix3d product = transform->rotation.transpose() * transform->rotation;
  EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_LT((transform->rotation - some_transform().rotation).norm(), 3e-4);
}

void expect_refused(std::array<double, 16> numbers, const char* why) {
  const auto transform = transform_from_row_major(numbers);
  ASSERT_FALSE(transform.ok()) << why;
  EXPECT_EQ(transform.error().code, ErrorCode::kMalformed) << why;
}

TEST(RigidTransform, parsing_refuses_transforms_that_are_not_rigid) {
  const auto good = row_major_from_transform(some_transform());
  auto scaled = good;
  for (int i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) scaled[static_cast<std::size_t>(i)] *= 1.01;
  expect_refused(scaled, "a scale");
  auto mirrored = good;
  for (std::size_t i : {0U, 4U, 8U}) mirrored[i] = -mirrored[i];
  expect_refused(mirrored, "a mirror");
  auto projective = good;
  projective[12] = 0.1;
  expect_refused(projective, "a last row that is not 0 0 0 1");
  auto infinite = good;
  infinite[3] = std::numeric_limits<double>::infinity();
  expect_refused(infinite, "an infinite translation");
  auto nan = good;
  nan[5] = std::nan("");
  expect_refused(nan, "a NaN in the rotation");
  expect_refused({}, "all zeros");
}

TEST(RigidTransform, exact_parsing_changes_no_bit) {
  auto rounded = row_major_from_transform(some_transform());
  rounded[0] += 1e-7;
  EXPECT_EQ(row_major_from_transform(exact_transform_from_row_major(rounded)), rounded);
}

TEST(RigidTransform, parsing_refuses_a_wrong_number_of_numbers) {
  const auto good = row_major_from_transform(some_transform());
  EXPECT_FALSE(transform_from_row_major(std::span(good).first(12)).ok());
  EXPECT_FALSE(transform_from_row_major({}).ok());
}

TEST(LookingAt, the_target_is_straight_ahead_and_up_is_up) {
  const Vector3d eye(1, 1.5, 2);
  const Vector3d target(-2, 0.5, -1);
  const RigidTransform world_from_optical = world_from_optical_looking_at(eye, target);
  const Vector3d target_in_optical = world_from_optical.inverse() * target;
  EXPECT_LT((target_in_optical - Vector3d(0, 0, (target - eye).norm())).norm(), 1e-12);
  EXPECT_LT(world_from_optical.rotation.col(1).y(), 0);           // picture down is world down
  EXPECT_NEAR(world_from_optical.rotation.col(0).y(), 0, 1e-12);  // no roll
  EXPECT_NEAR(world_from_optical.rotation.determinant(), 1, 1e-12);
}

TEST(LookingAt, straight_down_has_its_top_towards_minus_z) {
  for (const double direction : {-1.0, 1.0}) {
    const auto world_from_optical =
        world_from_optical_looking_at(Vector3d(0, 2, 0), Vector3d(0, 2 + direction, 0));
    EXPECT_LT((world_from_optical.rotation.col(1) - Vector3d(0, 0, 1)).norm(), 1e-12);
    EXPECT_NEAR(world_from_optical.rotation.determinant(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace roomcast
