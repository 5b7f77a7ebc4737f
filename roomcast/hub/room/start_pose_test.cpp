// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/start_pose.h"

#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

// Optical frames: x right, y down, z forward. The two sensors are 4 m apart and face each other
// along the world's z.
std::vector<RigidTransform> sensors_face_to_face() {
  return {world_from_optical_looking_at({0, 1.5, 2}, {0, 1.5, 0}),
          world_from_optical_looking_at({0, 1.5, -2}, {0, 1.5, 0})};
}

void expect_rotation(const RigidTransform& pose) {
  const Eigen::Matrix3d product = pose.rotation.transpose() * pose.rotation;
  EXPECT_TRUE(product.isIdentity(1e-12));
  EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
}

TEST(StartPose, stands_by_a_sensor_at_eye_height_and_looks_where_it_looks) {
  const RigidTransform pose = start_pose(sensors_face_to_face(), 0);
  expect_rotation(pose);
  EXPECT_NEAR(pose.translation_m.x(), 0, 0.5);
  EXPECT_NEAR(pose.translation_m.y(), 1.6, 1e-12);
  EXPECT_NEAR(pose.translation_m.z(), 2, 0.5);
  EXPECT_GT(pose.rotation.col(2).z(), 0.9) << "the viewer's -z is the sensor's z";
  EXPECT_GT(pose.rotation.col(1).y(), 0.9) << "upright";
}

TEST(StartPose, viewers_do_not_stand_inside_each_other) {
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < 6; ++i) poses.push_back(start_pose(sensors_face_to_face(), i));
  for (std::size_t a = 0; a < poses.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GT((poses[a].translation_m - poses[b].translation_m).norm(), 0.5) << a << " " << b;
  }
}

TEST(StartPose, exists_in_a_room_without_sensors) {
  expect_rotation(start_pose({}, 3));
}

TEST(StartPose, exists_for_a_sensor_that_looks_straight_down) {
  const std::vector sensors = {world_from_optical_looking_at({0, 2.5, 0}, {0, 0, 0})};
  expect_rotation(start_pose(sensors, 0));
  expect_rotation(start_pose(sensors, 1));
}

}  // namespace
}  // namespace roomcast::hub
