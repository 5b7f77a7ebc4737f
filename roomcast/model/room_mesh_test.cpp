// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/room_mesh.h"

#include <gtest/gtest.h>

namespace roomcast::model {
namespace {

RoomMesh square_and_triangle() {
  RoomMesh mesh;
  mesh.points_m = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                   {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  mesh.colors.assign(8, Rgb8{1, 2, 3});
  mesh.triangles = {{1, 2, 3}, {1, 3, 4}, {5, 6, 7}};
  return mesh;
}

TEST(RoomMesh, normals_point_to_where_triangles_are_counter_clockwise) {
  for (const Eigen::Vector3f& normal : point_normals(square_and_triangle()))
    EXPECT_TRUE(normal == Eigen::Vector3f::UnitZ() || normal == Eigen::Vector3f::UnitY());
}

TEST(RoomMesh, small_parts_and_unused_points_are_removed) {
  RoomMesh mesh = square_and_triangle();
  remove_small_parts(2, mesh);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.points_m.size(), 4u);
  EXPECT_EQ(mesh.colors.size(), 4u);
  for (const auto& triangle : mesh.triangles)
    for (const auto point : triangle) EXPECT_LT(mesh.points_m[point].x(), 2);
}

TEST(RoomMesh, an_empty_mesh_stays_empty) {
  RoomMesh mesh;
  remove_small_parts(10, mesh);
  EXPECT_TRUE(mesh.points_m.empty());
  EXPECT_TRUE(point_normals(mesh).empty());
}

}  // namespace
}  // namespace roomcast::model
