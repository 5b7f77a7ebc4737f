// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/real/real_bench.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::bench {
namespace {

/// Two sensors at one place look at a striped wall 2 m away; nothing moves.
class RealBenchTest : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<recording::RigSensor> sensors(2);
    for (std::size_t s = 0; s < sensors.size(); ++s) {
      auto& description = sensors[s].description;
      description.name = "s" + std::to_string(s);
      description.calibration.depth = description.calibration.color = kLens;
      description.calibration.color_is_registered = true;
    }
    auto writer = recording::RigWriter::create(folder / "rig", 30, sensors);
    ASSERT_TRUE(writer.ok()) << writer.error().message;
    source::CapturedFrame frame;
    frame.depth_mm = DepthImage(kLens.width, kLens.height, 2000);
    frame.color = ColorImage(kLens.width, kLens.height, render::kRed);
    for (int x = 0; x < kLens.width; x += 16)
      render::fill_box(frame.color, x, 0, x + 8, kLens.height, render::kGreen);
    for (; frame.index < 4; ++frame.index) {
      const nanoseconds time(33'333'333 * static_cast<std::int64_t>(frame.index + 1));
      for (std::size_t s = 0; s < 2; ++s) ASSERT_TRUE(writer->add(s, frame, time).ok());
    }
    ASSERT_TRUE(writer->finish().ok());
  }

  /// Both sensors where they are, the second shifted to the side.
  static alignment::AlignmentReport placed(double shift_m) {
    alignment::AlignmentReport report;
    for (const char* id : {"s0", "s1"}) {
      alignment::SensorReport sensor;
      sensor.id = id;
      sensor.placed = true;
      sensor.world_from_depth = RigidTransform{};
      report.sensors.push_back(sensor);
    }
    report.sensors[1].world_from_depth->translation_m.x() = shift_m;
    return report;
  }

  Result<RealReport> run(const alignment::AlignmentReport& alignment) const {
    return run_real_bench(folder / "rig", alignment, {.left_out_pictures = 2, .codec_frames = 4},
                          {});
  }

  const CameraIntrinsics kLens = render::pinhole(96, 72, 80);
  const TemporaryFolder folder;
};

TEST_F(RealBenchTest, a_sensor_is_drawn_from_the_other) {
  const auto report = run(placed(0));
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->left_out.size(), 4U) << report->not_drawn;
  for (const LeftOutPicture& picture : report->left_out) {
    EXPECT_GT(picture.psnr_db, 20) << picture.sensor << ", frame " << picture.frame;
    EXPECT_GT(picture.covered, 0.9);
    EXPECT_EQ(picture.wrong_depth, 0);
    EXPECT_EQ(picture.drawn.width(), kLens.width);
  }
}

TEST_F(RealBenchTest, a_wrong_pose_lowers_the_score) {
  const auto right = run(placed(0));
  const auto wrong = run(placed(0.1));  // half a stripe's period at 2 m is 0.2 m
  ASSERT_TRUE(right.ok() && wrong.ok());
  EXPECT_LT(wrong->left_out[0].psnr_db, right->left_out[0].psnr_db - 5);
}

TEST_F(RealBenchTest, bytes_are_measured_for_each_sensor) {
  const auto report = run(placed(0));
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->bytes.size(), 2U);
  EXPECT_FALSE(report->bytes[1].rows.empty());
}

TEST_F(RealBenchTest, with_one_placed_sensor_it_says_why_nothing_is_drawn) {
  auto alignment = placed(0);
  alignment.sensors[1].placed = false;
  const auto report = run(alignment);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->left_out.empty());
  EXPECT_NE(report->not_drawn.find("two sensors"), std::string::npos) << report->not_drawn;
}

TEST_F(RealBenchTest, the_page_shows_both_pictures_and_escapes_names) {
  auto report = run(placed(0));
  ASSERT_TRUE(report.ok());
  report->rig = report->conditions.at(0).sensor = "<script>alert(1)</script>";
  report->judgement.ball = {{"s0", "s1", 30, 12.4, 9.6}};
  ASSERT_TRUE(write_page({*report}, folder / "page").ok());
  std::ifstream file(folder / "page" / "index.html");
  const std::string html((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_NE(html.find("rig0-picture0-drawn.jpg"), std::string::npos);
  for (const char* part : {"<svg", "Infrared interference", "The ball", "<td>12<td>10", "Bytes"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_TRUE(std::filesystem::exists(folder / "page" / "rig0-picture3-own.jpg"));
}

TEST_F(RealBenchTest, reports_are_printed_as_table_and_json) {
  const auto report = run(placed(0));
  ASSERT_TRUE(report.ok());
  std::ostringstream table, json;
  print_table(*report, table);
  print_json({*report}, json);
  EXPECT_NE(table.str().find("left out"), std::string::npos);
  const auto parsed = nlohmann::json::parse(json.str());
  EXPECT_EQ(parsed.at(0).at("left_out").size(), 4U);
  EXPECT_EQ(parsed.at(0).at("conditions").size(), 2U);
  EXPECT_NE(table.str().find("noise"), std::string::npos);
  EXPECT_EQ(parsed.at(0).at("sensors").at(1).at("id"), "s1");
}

}  // namespace
}  // namespace roomcast::bench
