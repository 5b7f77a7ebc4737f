// SPDX-License-Identifier: Apache-2.0
#include "bench/model/mesh_depth.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

const CameraIntrinsics kLens = {
    .width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 31.5, .cy = 23.5};

/// A square of 1 m at z = 2 m before an optical frame, facing it.
model::RoomMesh square() {
  model::RoomMesh mesh;
  mesh.points_m = {{-0.5F, -0.5F, 2}, {0.5F, -0.5F, 2}, {0.5F, 0.5F, 2}, {-0.5F, 0.5F, 2}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

TEST(MeshDepth, is_that_of_the_surface) {
  const auto depth_m = mesh_depth_m(square(), kLens, {});
  EXPECT_NEAR(depth_m.at(32, 24), 2, 1e-5);
  EXPECT_NEAR(depth_m.at(20, 12), 2, 1e-5);
  EXPECT_EQ(depth_m.at(5, 24), 0);
}

TEST(MeshDepth, has_no_gaps_between_triangles) {
  const auto depth_m = mesh_depth_m(square(), kLens, {});
  for (int y = 12; y < 36; ++y)
    for (int x = 20; x < 44; ++x) EXPECT_GT(depth_m.at(x, y), 0) << x << " " << y;
}

TEST(MeshDepth, is_perspective_on_a_slant) {
  model::RoomMesh mesh = square();
  mesh.points_m[1].z() = mesh.points_m[2].z() = 3;  // z = 2.5 + x
  const auto depth_m = mesh_depth_m(mesh, kLens, {});
  const double ray = (30 - 31.5) / 60;
  EXPECT_NEAR(depth_m.at(30, 24), 2.5 / (1 - ray), 1e-4);
}

TEST(MeshDepth, backs_are_not_drawn) {
  model::RoomMesh mesh = square();
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_EQ(mesh_depth_m(mesh, kLens, {}).at(32, 24), 0);
}

TEST(MeshDepth, what_is_behind_the_camera_is_not_drawn) {
  RigidTransform pose;
  pose.translation_m.z() = 5;
  EXPECT_EQ(mesh_depth_m(square(), kLens, pose).at(32, 24), 0);
}

}  // namespace
}  // namespace roomcast::bench
