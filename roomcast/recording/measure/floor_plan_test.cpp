// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/floor_plan.h"

#include <gtest/gtest.h>

#include "roomcast/recording/measure/box_room_fixture.h"

namespace roomcast::recording {
namespace {

TEST(FloorPlan, an_empty_room_has_its_four_walls_with_corners) {
  const auto plan = draw_floor_plan(box_room());
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->walls.size(), 4u);
  for (const Wall& wall : plan->walls) {
    const bool across = std::abs(wall.normal.x()) > 0.5;
    EXPECT_NEAR(wall.offset_m(), across ? -2 : -2.5, 0.005);  // normals point into the room
    EXPECT_NEAR(wall.length_m(), across ? 5 : 4, 0.02);
  }
}

TEST(FloorPlan, a_cupboard_is_no_wall) {
  auto room = box_room();
  // A plane 0.6 m in front of the wall at z = 2.5, 1 m wide and 2 m high, as seen by sensor a.
  for (StaticSensor& sensor : room) {
    for (int y = 0; y < sensor.depth.height; ++y) {
      for (int x = 0; x < sensor.depth.width; ++x) {
        const auto ray = *unproject(sensor.depth, {x, y}, 1);
        const Eigen::Vector3d way = sensor.world_from_depth.rotation * ray;
        const double z_m = (1.9 - sensor.world_from_depth.translation_m.z()) / way.z();
        const Eigen::Vector3d hit = sensor.world_from_depth.translation_m + way * z_m;
        const bool on_it = z_m > 0 && std::abs(hit.x()) < 0.5 && hit.y() < 2;
        if (on_it && 1000 * z_m < sensor.depth_mm.at(x, y))
          sensor.depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * z_m));
      }
    }
  }
  const auto plan = draw_floor_plan(room);
  ASSERT_TRUE(plan.ok());
  for (const Wall& wall : plan->walls) EXPECT_LT(wall.offset_m(), -1.98);
  EXPECT_EQ(plan->walls.size(), 4u);
}

TEST(FloorPlan, is_a_picture_with_lengths_sensors_and_a_scale) {
  auto room = box_room();
  room[0].name = "<a>";
  const std::string svg = floor_plan_svg(*draw_floor_plan(room), "lab & hall");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_NE(svg.find("1 m</text>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;a>"), std::string::npos);
  EXPECT_NE(svg.find("lab &amp; hall"), std::string::npos);
  EXPECT_NE(svg.find("5.00 m"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(FloorPlan, needs_a_wall) {
  auto room = box_room();
  for (StaticSensor& sensor : room)
    sensor.depth_mm = DepthImage(sensor.depth.width, sensor.depth.height);
  EXPECT_EQ(draw_floor_plan(room).error().code, ErrorCode::kNotFound);
}

TEST(WallFinder, finds_no_wall_without_points) {
  EXPECT_TRUE(find_walls({}).empty());
}

}  // namespace
}  // namespace roomcast::recording
