// SPDX-License-Identifier: Apache-2.0
#include "bench/align/rig_error.h"

#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

const Eigen::Vector3d kMiddle_m(0, 1, 0);

RigidTransform turned(double angle_rad, const Eigen::Vector3d& shift_m) {
  RigidTransform transform;
  transform.rotation = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  transform.translation_m = shift_m;
  return transform;
}

/// Four sensors in the corners of a room.
std::vector<RigidTransform> corners() {
  return {turned(0.8, {2, 2, 2}), turned(2.4, {2, 2, -2}), turned(-2.3, {-2, 2, -2}),
          turned(-0.7, {-2, 2, 2})};
}

TEST(RigError, a_common_offset_of_all_sensors_is_no_error) {
  std::vector<RigidTransform> found;
  for (const RigidTransform& pose : corners()) found.push_back(turned(1.1, {3, 4, 5}) * pose);
  const RigError error = rig_error(corners(), found, kMiddle_m);
  EXPECT_LT(error.from_all_mm, 1e-6);
  EXPECT_LT(error.from_first_mm, 1e-6);
  EXPECT_LT(error.from_all_deg, 1e-4);
}

TEST(RigError, one_sensor_that_is_shifted_moves_the_mean_by_a_quarter) {
  std::vector<RigidTransform> found = corners();
  found[2].translation_m.x() += 0.008;
  const RigError error = rig_error(corners(), found, kMiddle_m);
  EXPECT_NEAR(error.from_all_mm, 6, 1e-6);
  EXPECT_NEAR(error.from_first_mm, 8, 1e-6);
  EXPECT_LT(error.from_all_deg, 1e-4);
}

TEST(RigError, a_turn_on_the_spot_moves_the_middle_of_the_view) {
  std::vector<RigidTransform> found = corners();
  const double turn_rad = 0.2 * std::numbers::pi / 180;
  found[0].rotation = found[0].rotation * turned(turn_rad, {0, 0, 0}).rotation;
  const RigError error = rig_error(corners(), found, kMiddle_m);
  const double from_axis_m = std::hypot(2.0, 2.0);
  EXPECT_NEAR(error.from_first_mm, 1000 * from_axis_m * turn_rad, 0.01);
  EXPECT_NEAR(error.from_first_deg, 0.2, 1e-6);
}

}  // namespace
}  // namespace roomcast::bench
