// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/mesh_writer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

class MeshWriterTest : public testing::Test {
 protected:
  Result<std::unique_ptr<SetWriter>> make(const MeshWriterOptions& options = {},
                                          std::stop_token stop = {}) const {
    return make_mesh_writer(out, wall_sensors(), options, {}, std::move(stop));
  }
  TemporaryFolder folder;
  std::filesystem::path out = folder / "out";
};

TEST_F(MeshWriterTest, writes_the_chosen_files) {
  MeshWriterOptions options;
  options.files = {MeshFile::kGlb, MeshFile::kPly, MeshFile::kObj};
  auto writer = make(options);
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE((*writer)->add(wall_set()));
  ASSERT_TRUE((*writer)->finish());
  EXPECT_GT((*writer)->totals().triangles, 1000u);
  for (const char* name : {"room.glb", "room.ply", "room.obj"})
    EXPECT_GT(std::filesystem::file_size(out / name), 10'000u) << name;
}

TEST_F(MeshWriterTest, the_mesh_is_where_the_wall_is) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(wall_set()));
  const auto mesh = mesh_room(views, {}, {}, {});
  ASSERT_TRUE(mesh);
  for (const auto& point : mesh->points_m) ASSERT_NEAR(point.z(), -2, 0.001);
}

TEST_F(MeshWriterTest, color_comes_from_the_best_view) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(wall_set()));
  const auto mesh = mesh_room(views, {}, {}, {});
  ASSERT_TRUE(mesh);
  std::size_t of_near = 0, of_far = 0;
  for (const Rgb8 color : mesh->colors) {
    of_near += color.r > 180 && color.g < 20;
    of_far += color.g > 180 && color.r < 20;
  }
  EXPECT_GT(of_near, 10'000u);
  EXPECT_GT(of_far, 10'000u);
  EXPECT_GT(of_near + of_far, mesh->colors.size() * 95 / 100);
}

TEST_F(MeshWriterTest, triangles_outside_of_the_crop_are_left_out) {
  MeshWriterOptions options;
  options.crop_m =
      Eigen::AlignedBox3f(Eigen::Vector3f(-0.3F, 0.7F, -3), Eigen::Vector3f(0, 1.3F, 0));
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(wall_set()));
  const auto mesh = mesh_room(views, options, {}, {});
  ASSERT_TRUE(mesh);
  for (const auto& point : mesh->points_m) ASSERT_TRUE(options.crop_m->contains(point));
  options.crop_m = Eigen::AlignedBox3f(Eigen::Vector3f(5, 5, 5), Eigen::Vector3f(6, 6, 6));
  ASSERT_TRUE(views.add(wall_set()));
  EXPECT_EQ(mesh_room(views, options, {}, {}).error().code, ErrorCode::kNotFound);
}

TEST_F(MeshWriterTest, says_so_when_no_sensor_is_placed) {
  auto writer = make();
  FrameSet set = wall_set();
  for (SetFrame& frame : set.frames) frame.world_from_depth.reset();
  ASSERT_TRUE((*writer)->add(set));
  const auto status = (*writer)->finish();
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("no sensor of this recording is placed"),
            std::string::npos);
}

TEST_F(MeshWriterTest, writes_nothing_after_an_interruption) {
  std::stop_source stop;
  auto writer = make({}, stop.get_token());
  ASSERT_TRUE((*writer)->add(wall_set()));
  stop.request_stop();
  (void)(*writer)->finish();
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST_F(MeshWriterTest, writes_nothing_after_a_set_that_cannot_be_fused) {
  auto writer = make();
  FrameSet set = wall_set();
  ASSERT_TRUE((*writer)->add(set));
  set.frames[0].world_from_depth->translation_m.x() = 1e9;
  set.frames[0].time = std::chrono::seconds(1);
  EXPECT_FALSE((*writer)->add(set));
  EXPECT_TRUE((*writer)->finish());
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST_F(MeshWriterTest, refuses_options_out_of_range) {
  MeshWriterOptions options;
  options.model.voxel_m = 0.0001F;
  EXPECT_FALSE(make(options));
  options = {};
  options.crop_m = Eigen::AlignedBox3f();
  EXPECT_FALSE(make(options));
}

}  // namespace
}  // namespace roomcast::recording
