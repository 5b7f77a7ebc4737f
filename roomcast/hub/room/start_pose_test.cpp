// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/start_pose.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

// Optical frames: x right, y down, z forward. The two sensors are 4 m apart and face each other
// along the world's z.
constexpr Matrix4 kLookingTowardsMinusZ = {1, 0, 0, 0, 0, -1, 0, 1.5, 0, 0, -1, 2, 0, 0, 0, 1};
constexpr Matrix4 kLookingTowardsPlusZ = {-1, 0, 0, 0, 0, -1, 0, 1.5, 0, 0, 1, -2, 0, 0, 0, 1};

double dot(const Matrix4& m, int a, int b) {
  return m[a] * m[b] + m[a + 4] * m[b + 4] + m[a + 8] * m[b + 8];
}

void expect_rotation(const Matrix4& m) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(dot(m, a, b), a == b ? 1 : 0, 1e-12);
  }
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) -
                             m[1] * (m[4] * m[10] - m[6] * m[8]) +
                             m[2] * (m[4] * m[9] - m[5] * m[8]);
  EXPECT_NEAR(determinant, 1, 1e-12);
}

TEST(StartPose, stands_by_a_sensor_at_eye_height_and_looks_where_it_looks) {
  const std::vector<Matrix4> sensors = {kLookingTowardsMinusZ, kLookingTowardsPlusZ};
  const Matrix4 pose = start_pose(sensors, 0);
  expect_rotation(pose);
  EXPECT_NEAR(pose[3], 0, 0.5);
  EXPECT_NEAR(pose[7], 1.6, 1e-12);
  EXPECT_NEAR(pose[11], 2, 0.5);
  EXPECT_GT(pose[10], 0.9) << "the viewer's -z is the sensor's z";
  EXPECT_GT(pose[5], 0.9) << "upright";
}

TEST(StartPose, viewers_do_not_stand_inside_each_other) {
  const std::vector<Matrix4> sensors = {kLookingTowardsMinusZ, kLookingTowardsPlusZ};
  std::vector<Matrix4> poses;
  for (std::size_t i = 0; i < 6; ++i) poses.push_back(start_pose(sensors, i));
  for (std::size_t a = 0; a < poses.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_GT(std::hypot(poses[a][3] - poses[b][3], poses[a][11] - poses[b][11]), 0.5)
          << a << " " << b;
    }
  }
}

TEST(StartPose, exists_in_a_room_without_sensors) {
  expect_rotation(start_pose({}, 3));
}

TEST(StartPose, exists_for_a_sensor_that_looks_straight_down) {
  const std::vector<Matrix4> sensors = {{1, 0, 0, 0, 0, 0, -1, 2.5, 0, 1, 0, 0, 0, 0, 0, 1}};
  expect_rotation(start_pose(sensors, 0));
  expect_rotation(start_pose(sensors, 1));
}

}  // namespace
}  // namespace roomcast::hub
