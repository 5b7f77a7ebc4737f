// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/scene/room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/source/simulator/people/walking_body.h"

namespace roomcast::sim {
namespace {

using testing::HasSubstr;

class Rooms : public testing::TestWithParam<const char*> {
 protected:
  Room room_ = build_room(GetParam(), 1).value();
};
INSTANTIATE_TEST_SUITE_P(Scenes, Rooms, testing::Values("livingroom", "office"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(Rooms, triangles_name_vertices_and_surfaces_that_exist) {
  const TriangleMesh& mesh = room_.mesh;
  ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
  ASSERT_EQ(mesh.positions.size(), mesh.uv_m.size());
  ASSERT_EQ(mesh.triangles.size(), mesh.surface.size());
  for (const auto& triangle : mesh.triangles) {
    for (const auto corner : triangle) ASSERT_LT(corner, mesh.positions.size());
  }
  for (const auto surface : mesh.surface) ASSERT_LT(surface, room_.surfaces.size());
}

TEST_P(Rooms, everything_is_inside_the_walls) {
  constexpr float kSlack_m = 0.06F;  // lamps go into the ceiling
  const Eigen::Vector3f half = 0.5F * room_.size_m + Eigen::Vector3f::Constant(kSlack_m);
  for (const auto& point : room_.mesh.positions) {
    ASSERT_TRUE(point.allFinite());
    ASSERT_LE(std::abs(point.x()), half.x());
    ASSERT_LE(std::abs(point.z()), half.z());
    ASSERT_GE(point.y(), -1e-4F);
    ASSERT_LE(point.y(), room_.size_m.y() + kSlack_m);
  }
}

TEST_P(Rooms, walk_keeps_clear_of_the_furniture) {
  constexpr float kShoulders_m = 0.26F;
  constexpr float kRug_m = 0.02F, kHead_m = 1.8F;
  for (int i = 0; i < 64; ++i) {
    const auto body = WalkingBody::at(room_.walk, room_.walk.lap * i / 64);
    for (const auto& point : room_.mesh.positions) {
      if (point.y() < kRug_m || point.y() > kHead_m) continue;
      const Eigen::Vector3f away = point - body.floor_point_m();
      ASSERT_GT(std::hypot(away.x(), away.z()), kShoulders_m) << point.transpose();
    }
  }
}

TEST_P(Rooms, sensors_stand_inside_at_sensible_heights) {
  for (const SensorStand& stand : room_.stands) {
    EXPECT_GE(stand.eye_m.y(), 1.2F);
    EXPECT_LE(stand.eye_m.y(), 2.2F);
    EXPECT_LT(std::abs(stand.eye_m.x()), 0.5F * room_.size_m.x());
    EXPECT_LT(std::abs(stand.eye_m.z()), 0.5F * room_.size_m.z());
  }
}

TEST(Room, no_name_is_the_living_room) {
  EXPECT_EQ(build_room("", 1)->name, "livingroom");
}

TEST(Room, unknown_scene_is_refused_with_a_list_of_scenes) {
  const auto room = build_room("kitchen", 1);
  ASSERT_FALSE(room);
  EXPECT_EQ(room.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(room.error().message, HasSubstr("kitchen"));
  EXPECT_THAT(room.error().message, HasSubstr("livingroom"));
  EXPECT_THAT(room.error().message, HasSubstr("office"));
}

}  // namespace
}  // namespace roomcast::sim
