// SPDX-License-Identifier: Apache-2.0
#include "bench/render/render_bench.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

class RenderBenchTest : public testing::Test {
 protected:
  /// A striped wall 2 m away. A sensor and an eye at the same position see the same picture. Four
  /// frames; nothing moves between the two times of the views.
  void write_rig() const {
    recording::RigSensor sensor;
    sensor.description.name = "s0";
    sensor.description.calibration.depth = sensor.description.calibration.color = kLens;
    sensor.description.calibration.color_is_registered = true;
    sensor.description.world_from_depth = RigidTransform{};
    auto writer = recording::RigWriter::create(folder / "rig", 30, std::vector{sensor});
    ASSERT_TRUE(writer.ok()) << writer.error().message;
    source::CapturedFrame frame;
    frame.depth_mm = DepthImage(kLens.width, kLens.height, 2000);
    frame.color = stripes();
    for (; frame.index < 4; ++frame.index) {
      const nanoseconds time(33'333'333 * static_cast<std::int64_t>(frame.index + 1));
      ASSERT_TRUE(writer->add(0, frame, time).ok());
    }
    ASSERT_TRUE(writer->finish().ok());
    write_truth();
  }

  void write_truth() const {
    const fs::path truth = folder / "rig" / "truth";
    fs::create_directories(truth / "s0");
    const DepthImage depth(kLens.width, kLens.height, 2000);
    nlohmann::json views = {{"width", kLens.width}, {"height", kLens.height}, {"fy", kLens.fy}};
    for (const int instant : {0, 1}) {
      const std::string name = "view_0_t" + std::to_string(instant);
      ASSERT_TRUE(io::write_color_png(truth / (name + ".png"), stripes()).ok());
      ASSERT_TRUE(io::write_depth_png(truth / (name + "_depth.png"), depth).ok());
      const MaskImage seen(kLens.width, kLens.height, 1);
      ASSERT_TRUE(io::write_mask_png(truth / (name + "_seen.png"), seen).ok());
      ASSERT_TRUE(
          io::write_depth_png(truth / "s0" / (instant ? "000002.png" : "000001.png"), depth).ok());
      views["views"].push_back(
          {{"view", 0},
           {"instant", instant},
           {"color", name + ".png"},
           {"depth", name + "_depth.png"},
           {"seen", name + "_seen.png"},
           {"world_from_view", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
           {"frame", {{"s0", instant + 1}}}});
    }
    std::ofstream(truth / "views.json") << views.dump();
  }

  [[nodiscard]] ColorImage stripes() const {
    ColorImage image(kLens.width, kLens.height, render::kRed);
    for (int x = 0; x < kLens.width; x += 16)
      render::fill_box(image, x, 0, x + 8, kLens.height, render::kGreen);
    return image;
  }

  const CameraIntrinsics kLens = render::pinhole(96, 72, 80);
  const TemporaryFolder folder;
};

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
  EXPECT_NE(table.str().find("mesh"), std::string::npos);
  EXPECT_NE(table.str().find("two eyes at once"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
