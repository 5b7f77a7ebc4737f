// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/plane_finder.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/geometry/camera_model.h"
#include "roomcast/sensor/glossy_floor_fixture.h"

namespace roomcast::sensor {
namespace {

TEST(PlaneFinderTest, floor_and_wall_are_found) {
  const GlossyFloor room;
  const auto planes = find_planes(room.whole_depth_mm(), ray_table(room.lens()));
  ASSERT_GE(planes.size(), 2U);
  int floors = 0, walls = 0;
  for (const Plane& plane : planes) {
    floors += std::abs(plane.normal.y()) > 0.99F &&
              std::abs(std::abs(plane.distance_m) - GlossyFloor::kAbove_m) < 0.03F;
    walls += std::abs(plane.normal.z()) > 0.99F &&
             std::abs(std::abs(plane.distance_m) - GlossyFloor::kWall_m) < 0.03F;
  }
  EXPECT_EQ(floors, 1);
  EXPECT_EQ(walls, 1);
}

TEST(PlaneFinderTest, a_plane_is_met_in_front_of_the_sensor_only) {
  const Plane floor{{0, 1, 0}, 1.5F};
  EXPECT_NEAR(floor.depth_m({0, 0.5F}), 3, 1e-6F);
  EXPECT_EQ(floor.depth_m({0, -0.5F}), 0);
  EXPECT_EQ(floor.depth_m({0.3F, 0}), 0);
}

TEST(PlaneFinderTest, nothing_is_found_in_nothing) {
  const GlossyFloor room;
  EXPECT_TRUE(
      find_planes(DepthImage(GlossyFloor::kWidth, GlossyFloor::kHeight), ray_table(room.lens()))
          .empty());
}

}  // namespace
}  // namespace roomcast::sensor
