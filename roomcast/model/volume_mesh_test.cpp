// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/volume_mesh.h"

#include <map>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "roomcast/model/scene_fixture.h"

namespace roomcast::model {
namespace {

/// Lines between two points that do not occur once in each direction as often: the rims of a mesh.
int open_lines(const RoomMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> lines;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++lines[{t[i], t[(i + 1) % 3]}];
      --lines[{t[(i + 1) % 3], t[i]}];
    }
  }
  int open = 0;
  for (const auto& [line, count] : lines) open += count != 0;
  return open;
}

/// Two neighbouring blocks; `distance` gives units at a corner of the room's grid.
template <class Distance>
RoomVolume volume_of(const Distance& distance) {
  RoomVolume volume;
  for (int block = 0; block < 2; ++block) {
    volume.blocks.push_back({{block, 0, 0}, {}});
    for (int z = 0; z < kBlockCorners; ++z)
      for (int y = 0; y < kBlockCorners; ++y)
        for (int x = 0; x < kBlockCorners; ++x)
          volume.blocks.back().distances[VolumeBlock::index(x, y, z)] =
              static_cast<std::int16_t>(distance(kBlockCells * block + x, y, z));
  }
  return volume;
}

TEST(VolumeMesh, a_surface_of_any_shape_is_closed) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::map<std::array<int, 3>, int> drawn;
    const auto volume = volume_of([&](int x, int y, int z) {
      const bool rim = x == 0 || y == 0 || z == 0 || x == 16 || y == 8 || z == 8;
      const auto [place, is_new] = drawn.try_emplace({x, y, z}, 0);
      if (is_new) place->second = rim || random() % 2 == 0 ? 1000 : -1000;
      return place->second;
    });
    const RoomMesh mesh = mesh_volume(volume);
    EXPECT_GT(mesh.triangles.size(), 500u);
    EXPECT_EQ(open_lines(mesh), 0) << seed;
  }
}

TEST(VolumeMesh, a_ball_across_two_blocks_has_its_volume) {
  const auto volume = volume_of([](int x, int y, int z) {
    return std::lround(2048 * (Eigen::Vector3d(x - 8.2, y - 4.1, z - 3.9).norm() - 3));
  });
  const RoomMesh mesh = mesh_volume(volume);
  EXPECT_EQ(open_lines(mesh), 0);
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six_volumes += mesh.points_m[a].cross(mesh.points_m[b]).dot(mesh.points_m[c]);
  EXPECT_NEAR(six_volumes / 6 / (4.0 / 3 * M_PI * 27e-6), 0.94, 0.03);  // chords are inside
}

TEST(VolumeMesh, ends_where_distances_are_unknown) {
  const auto flat = [](int, int, int z) { return 1024 - 2048 * (z - 4); };
  const auto count = [](const RoomVolume& volume) { return mesh_volume(volume).triangles.size(); };
  const std::size_t all = count(volume_of(flat));
  EXPECT_EQ(all, 2u * 16 * 8);
  EXPECT_EQ(count(volume_of([&](int x, int y, int z) {
              return x < 8 ? flat(x, y, z) : VolumeBlock::kUnknown;
            })),
            2u * 7 * 8);
}

TEST(VolumeMesh, ends_a_voxel_after_the_outline_of_a_thing) {
  for (const int beyond : {6000, static_cast<int>(VolumeBlock::kHidden)}) {
    const auto volume =
        volume_of([&](int x, int, int z) { return x < 8 ? 1024 - 2048 * (z - 4) : beyond; });
    EXPECT_EQ(mesh_volume(volume).triangles.size(), 2u * 8 * 8) << beyond;
  }
}

std::vector<Eigen::Vector3f> no_gains(const std::vector<ViewSurface>& views) {
  return std::vector<Eigen::Vector3f>(views.size(), Eigen::Vector3f::Ones());
}

TEST(VolumeMesh, colors_are_those_that_the_views_see) {
  const auto views = look_from_all(known_scene);
  RoomMesh mesh = mesh_volume(*fuse_views(views, {}));
  color_mesh(views, no_gains(views), {}, {}, mesh);
  ASSERT_EQ(mesh.colors.size(), mesh.points_m.size());
  std::size_t right = 0;
  for (const Rgb8 color : mesh.colors) right += color == Rgb8{200, 100, 50};
  EXPECT_GT(right, mesh.colors.size() * 99 / 100);
}

TEST(VolumeMesh, without_colors_everything_is_grey) {
  StillView view = *StillView::create(fixture_camera(), fixture_poses()[0]);
  view.add(look(fixture_camera(), fixture_poses()[0], known_scene), {}, {});
  const std::vector<ViewSurface> views = {ViewSurface(view, {})};
  RoomMesh mesh = mesh_volume(*fuse_views(views, {}));
  color_mesh(views, no_gains(views), {}, {}, mesh);
  for (const Rgb8 color : mesh.colors) ASSERT_EQ(color, (Rgb8{128, 128, 128}));
}

TEST(VolumeMesh, what_has_no_colour_can_be_left_out) {
  RoomMesh mesh;
  mesh.points_m = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  mesh.colors = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, kNoColor};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}};
  remove_uncolored(mesh);
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.points_m.size(), 3u);
}

}  // namespace
}  // namespace roomcast::model
