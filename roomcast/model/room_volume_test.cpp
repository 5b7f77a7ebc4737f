// SPDX-License-Identifier: Apache-2.0
// The fused surface of a scene of which every distance is known, and input that no room gives.
#include "roomcast/model/room_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/model/scene_fixture.h"
#include "roomcast/model/volume_mesh.h"

namespace roomcast::model {
namespace {

RoomMesh mesh_of(const std::vector<ViewSurface>& views, const ModelOptions& options = {}) {
  const auto volume = fuse_views(views, options);
  EXPECT_TRUE(volume.ok());
  RoomMesh mesh = mesh_volume(*volume);
  remove_small_parts(options.min_triangles, mesh);
  return mesh;
}

/// Distances of the mesh's points from the true surface, sorted.
std::vector<double> errors_mm(const RoomMesh& mesh, const SceneDistance& scene) {
  std::vector<double> errors;
  for (const auto& point : mesh.points_m)
    errors.push_back(1000 * std::abs(scene(point.cast<double>())));
  std::ranges::sort(errors);
  return errors;
}

double percentile(const std::vector<double>& sorted, int percent) {
  return sorted[sorted.size() * static_cast<std::size_t>(percent) / 100];
}

TEST(RoomVolume, surfaces_of_exact_sensors_are_exact) {
  const auto errors = errors_mm(mesh_of(look_from_all(known_scene)), known_scene);
  ASSERT_GT(errors.size(), 30'000u);
  EXPECT_LT(percentile(errors, 50), 0.5);
  EXPECT_LT(percentile(errors, 95), 3);
  EXPECT_LT(percentile(errors, 99), 8);  // edges of the box
}

TEST(RoomVolume, noise_of_a_sensor_averages_out) {
  const auto errors = errors_mm(mesh_of(look_from_all(known_scene, {}, 20, 6)), known_scene);
  EXPECT_LT(percentile(errors, 50), 1.5);
  EXPECT_LT(percentile(errors, 95), 6);
}

TEST(RoomVolume, triangles_face_the_room) {
  const RoomMesh mesh = mesh_of(look_from_all(known_scene));
  const auto normals = point_normals(mesh);
  std::size_t right = 0;
  for (std::size_t i = 0; i < mesh.points_m.size(); ++i) {
    const Eigen::Vector3d in_front = (mesh.points_m[i] + 0.02F * normals[i]).cast<double>();
    right += known_scene(in_front) > 0;
  }
  EXPECT_GT(right, mesh.points_m.size() * 99 / 100);
}

TEST(RoomVolume, nothing_is_invented_behind_things) {
  // At outlines a surface may reach a voxel or two too far, not more: no flaps.
  const auto errors = errors_mm(mesh_of(look_from_all(known_scene)), known_scene);
  EXPECT_LT(errors[errors.size() * 999 / 1000], 20);
  EXPECT_LT(errors.back(), 80);  // a few points beside shadows
}

TEST(RoomVolume, a_board_seen_from_both_sides_keeps_its_thickness) {
  const SceneDistance board = [](const Eigen::Vector3d& at) {
    return box(at, {0, 0, 0}, {1, 1, 0.01});
  };
  std::vector<ViewSurface> views;
  for (const double z : {-2.0, 2.0}) {
    const auto pose = world_from_optical_looking_at({0, 0, z}, {0, 0, 0});
    StillView view = *StillView::create(fixture_camera(), pose);
    view.add(look(fixture_camera(), pose, board), {}, {});
    views.emplace_back(view, ModelOptions());
  }
  RoomMesh mesh = mesh_of(views);
  std::vector<double> thickness_mm;
  for (const auto& point : mesh.points_m)
    if (point.head<2>().cwiseAbs().maxCoeff() < 0.8F)
      thickness_mm.push_back(1000 * std::abs(point.z()));
  ASSERT_GT(thickness_mm.size(), 1000u);
  std::ranges::sort(thickness_mm);
  EXPECT_NEAR(percentile(thickness_mm, 50), 10, 3);
}

TEST(RoomVolume, what_one_sensor_sees_through_is_carved) {
  auto views = look_from_all(floor_and_wall);
  // One of the sensors also sees a ball, which the others see through.
  StillView ghost = *StillView::create(fixture_camera(), fixture_poses()[2]);
  ghost.add(look(fixture_camera(), fixture_poses()[2],
                 [](const Eigen::Vector3d& at) {
                   return std::min(floor_and_wall(at), ball(at, {0, 0.8, -0.5}, 0.15));
                 }),
            {}, {});
  views[2] = ViewSurface(ghost, {});
  const auto errors = errors_mm(mesh_of(views), floor_and_wall);
  EXPECT_LT(errors.back(), 40);
}

TEST(RoomVolume, pixels_that_are_read_now_and_then_leave_no_holes) {
  // Half of the readings are missing, in another pattern in each frame; a tenth are missing in all.
  const auto pose = fixture_poses()[2];
  StillView view = *StillView::create(fixture_camera(), pose);
  const DepthImage full_mm = look(fixture_camera(), pose, floor_and_wall);
  std::mt19937 random(5);
  MaskImage lost(256, 212);
  for (int y = 0; y < 212; ++y)
    for (int x = 0; x < 256; ++x) lost.at(x, y) = random() % 10 == 0;
  for (int frame = 0; frame < 10; ++frame) {
    DepthImage depth_mm = full_mm;
    for (int y = 0; y < 212; ++y)
      for (int x = 0; x < 256; ++x)
        if (lost.at(x, y) != 0 || random() % 2 == 0) depth_mm.at(x, y) = 0;
    view.add(depth_mm, {}, {});
  }
  StillView whole = *StillView::create(fixture_camera(), pose);
  whole.add(full_mm, {}, {});
  const std::vector<ViewSurface> sparse = {ViewSurface(view, {})}, dense = {ViewSurface(whole, {})};
  EXPECT_GT(mesh_of(sparse).triangles.size(), mesh_of(dense).triangles.size() * 97 / 100);
}

TEST(RoomVolume, a_passer_by_over_a_floor_that_returns_no_light_is_not_kept) {
  const auto pose = fixture_poses()[2];
  StillView view = *StillView::create(fixture_camera(), pose);
  for (int frame = 0; frame < 20; ++frame) {
    DepthImage depth_mm(256, 212);
    for (int y = 60; y < 160; ++y)
      for (int x = 12 * frame; x < 12 * frame + 16; ++x) depth_mm.at(x, y) = 1500;
    view.add(depth_mm, {}, {});
  }
  const std::vector<ViewSurface> views = {ViewSurface(view, {})};
  EXPECT_TRUE(mesh_of(views).triangles.empty());
}

TEST(RoomVolume, says_what_to_do_when_memory_is_short) {
  ModelOptions options;
  options.max_bytes = 500'000;
  const auto volume = fuse_views(look_from_all(known_scene), options);
  ASSERT_FALSE(volume);
  EXPECT_EQ(volume.error().code, ErrorCode::kTooLarge);
  EXPECT_NE(volume.error().message.find("--voxel"), std::string::npos);
}

TEST(RoomVolume, is_the_same_on_any_number_of_threads) {
  const auto views = look_from_all(known_scene);
  const auto one = fuse_views(views, {}, {1}), three = fuse_views(views, {}, {3});
  ASSERT_EQ(one->blocks.size(), three->blocks.size());
  for (std::size_t i = 0; i < one->blocks.size(); ++i) {
    ASSERT_EQ(one->blocks[i].place, three->blocks[i].place);
    ASSERT_EQ(one->blocks[i].distances, three->blocks[i].distances);
  }
}

TEST(RoomVolume, readings_without_sense_give_a_bounded_volume) {
  DepthImage noise_mm(256, 212);
  std::mt19937 random(3);
  for (int y = 0; y < 212; ++y)
    for (int x = 0; x < 256; ++x) noise_mm.at(x, y) = static_cast<std::uint16_t>(random());
  StillView view = *StillView::create(fixture_camera(), fixture_poses()[0]);
  view.add(noise_mm, {}, {});
  const std::vector<ViewSurface> views = {ViewSurface(view, {})};
  ModelOptions options;
  options.voxel_m = kMinVoxel_m;
  const auto volume = fuse_views(views, options);
  EXPECT_TRUE(!volume || volume->bytes() <= options.max_bytes);
}

TEST(RoomVolume, no_views_are_an_empty_room) {
  const auto volume = fuse_views({}, {});
  ASSERT_TRUE(volume);
  EXPECT_TRUE(volume->blocks.empty());
}

TEST(RoomVolume, refuses_options_out_of_range) {
  ModelOptions options;
  options.voxel_m = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(fuse_views({}, options));
  options.voxel_m = 0;
  EXPECT_FALSE(fuse_views({}, options));
}

}  // namespace
}  // namespace roomcast::model
