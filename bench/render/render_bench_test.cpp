// SPDX-License-Identifier: Apache-2.0
#include "bench/render/render_bench.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/render/striped_rig_fixture.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

using RenderBenchTest = StripedRigTest;

TEST_F(RenderBenchTest, without_true_views_says_how_to_get_them) {
  const auto report = run_render_bench({.rig = folder.path()}, {});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("--views"), std::string::npos) << report.error().message;
}

TEST_F(RenderBenchTest, damaged_views_are_named) {
  fs::create_directories(folder / "truth");
  std::ofstream(folder / "rig.json") << R"({"fps": 30, "sensors": []})";
  std::ofstream(folder / "truth" / "views.json") << R"({"views": [{"view": "zero"}]})";
  const auto report = run_render_bench({.rig = folder.path()}, {});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("json"), std::string::npos) << report.error().message;
}

TEST_F(RenderBenchTest, wrong_poses_make_pictures_worse) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  RenderBenchOptions options{.rig = folder / "rig", .modes = {render::RenderMode::kMesh}};
  const auto right = run_render_bench(options, {});
  options.pose_error_mm = 200;
  options.pose_error_deg = 5;
  const auto wrong = run_render_bench(options, {});
  ASSERT_TRUE(right.ok() && wrong.ok());
  EXPECT_LT(wrong->rows[0].score.psnr_visible, right->rows[0].score.psnr_visible - 3);
}

TEST_F(RenderBenchTest, the_model_shows_the_room_without_its_sensors) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  const RenderBenchOptions options{
      .rig = folder / "rig", .modes = {render::RenderMode::kStill}, .model = true};
  const auto report = run_render_bench(options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_GT(report->rows.at(0).score.psnr_visible, 12);
  EXPECT_LT(report->rows.at(0).score.holes, 0.1);
}

TEST_F(RenderBenchTest, what_stands_where_a_frame_shows_something_farther_has_a_silhouette) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  const fs::path frame = folder / "rig" / "truth" / "s0" / "000000.png";
  const DepthImage farther(kLens.width, kLens.height, 3000);
  ASSERT_TRUE(io::write_depth_png(frame, farther).ok());
  RenderBenchOptions options{.rig = folder / "rig", .modes = {render::RenderMode::kMesh}};
  options.pictures = folder / "drawn";
  const auto report = run_render_bench(options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_LT(report->rows.at(0).score.silhouette_missing, 0.06);
  EXPECT_EQ(report->rows.at(0).score.silhouette_doubled, 0);
  EXPECT_TRUE(fs::exists(folder / "drawn" / "view0_t0_mesh_silhouette.png"));
}

TEST_F(RenderBenchTest, judges_every_mode) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  RenderBenchOptions options{.rig = folder / "rig"};
  options.pictures = folder / "drawn";
  options.stereo = true;
  const auto report = run_render_bench(options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->rows.size(), render::kRenderModes.size());
  EXPECT_EQ(report->views, 2);
  for (const RenderRow& row : report->rows) {
    EXPECT_GT(row.score.psnr_visible, 15) << row.mode << ": the border is black";
    EXPECT_LT(row.score.holes, 0.06) << row.mode << ": half a cell is missing at the border";
    EXPECT_EQ(row.score.wrong_depth, 0) << row.mode;
    EXPECT_GT(row.points_cpu_ms, 0) << row.mode;
    EXPECT_GT(row.stereo.at_once_cpu_ms, 0) << row.mode;
    EXPECT_GT(row.stereo.one_by_one_cpu_ms, 0) << row.mode;
  }
  EXPECT_TRUE(fs::exists(folder / "drawn" / "view0_t0_mesh.png"));
  std::ostringstream json, table;
  print_json(*report, json);
  print_table(*report, table);
  EXPECT_EQ(nlohmann::json::parse(json.str()).at("rows").size(), report->rows.size());
  EXPECT_TRUE(nlohmann::json::parse(json.str()).at("rows").at(0).at("silhouette_missing").is_null())
      << "nothing moves";
  EXPECT_NE(table.str().find("mesh"), std::string::npos);
  EXPECT_NE(table.str().find("two eyes at once"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
