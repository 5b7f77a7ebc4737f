// SPDX-License-Identifier: Apache-2.0
#include "bench/render/render_bench.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "roomcast/source/simulate_rig.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

class RenderBenchTest : public testing::Test {
 protected:
  RenderBenchTest() {
    std::string name = (fs::temp_directory_path() / "roomcast-render-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~RenderBenchTest() override { fs::remove_all(folder); }

  void simulate() {
    SimulateRigOptions options;
    options.scene = "bare";
    options.sensor_count = 2;
    options.seconds = 0.1;
    options.views = 1;
    options.view_side_px = 200;
    const auto made = simulate_rig(folder / "rig", options);
    ASSERT_TRUE(made.ok()) << made.error().message;
  }

  fs::path folder;
};

TEST_F(RenderBenchTest, without_true_views_says_how_to_get_them) {
  const auto report = run_render_bench({.rig = folder}, {});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("--views"), std::string::npos) << report.error().message;
}

TEST_F(RenderBenchTest, damaged_views_are_named) {
  fs::create_directories(folder / "truth");
  std::ofstream(folder / "rig.json") << R"({"fps": 30, "sensors": []})";
  std::ofstream(folder / "truth" / "views.json") << R"({"views": [{"view": "zero"}]})";
  const auto report = run_render_bench({.rig = folder}, {});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("json"), std::string::npos) << report.error().message;
}

TEST_F(RenderBenchTest, judges_every_mode_on_a_simulated_rig) {
  ASSERT_NO_FATAL_FAILURE(simulate());
  RenderBenchOptions options{.rig = folder / "rig"};
  options.pictures = folder / "drawn";
  const auto report = run_render_bench(options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->rows.size(), kRenderModes.size());
  EXPECT_EQ(report->views, 2);
  const RenderRow &points = report->rows[0], &mesh = report->rows[2];
  EXPECT_EQ(points.draw_per_points, 1);
  EXPECT_GT(mesh.score.psnr_visible, points.score.psnr_visible) << "a mesh has fewer holes";
  EXPECT_LT(mesh.score.holes, points.score.holes);
  EXPECT_TRUE(fs::exists(folder / "drawn" / "view0_t0_mesh.png"));
  std::ostringstream json, table;
  print_json(*report, json);
  print_table(*report, table);
  EXPECT_EQ(nlohmann::json::parse(json.str()).at("rows").size(), report->rows.size());
  EXPECT_NE(table.str().find("mesh"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
