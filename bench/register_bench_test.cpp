// SPDX-License-Identifier: Apache-2.0
#include "bench/register_bench.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

constexpr RegisterBenchOptions kShort{.cpu_seconds_per_row = 0};

TEST(RegisterBench, gives_a_fast_and_a_reference_row_for_each_input) {
  const auto report = run_register_bench({synthetic_kinect_v2_input()}, kShort);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->depth_width, 512);
  EXPECT_EQ(report->color_height, 1080);
  ASSERT_EQ(report->rows.size(), 2U);
  EXPECT_EQ(report->rows[0].version, "fast");
  EXPECT_EQ(report->rows[1].version, "reference");
  EXPECT_GT(report->rows[0].cpu_ms, 0);
  EXPECT_NEAR(report->rows[0].frames_per_cpu_s * report->rows[0].cpu_ms, 1000, 1e-6);
  EXPECT_NEAR(report->rows[0].times_reference * report->rows[0].cpu_ms, report->rows[1].cpu_ms,
              1e-9);
}

TEST(RegisterBench, the_synthetic_frame_exercises_seen_and_hidden_pixels) {
  const auto report = run_register_bench({synthetic_kinect_v2_input()}, kShort);
  ASSERT_TRUE(report.ok());
  EXPECT_GT(report->rows[0].seen_share, 0.6);
  EXPECT_LT(report->rows[0].seen_share, 0.95);
}

TEST(RegisterBench, refuses_inputs_without_frames_or_of_mixed_sizes) {
  RegisterBenchInput empty = synthetic_kinect_v2_input();
  empty.frames.clear();
  EXPECT_FALSE(run_register_bench({empty}, kShort).ok());
  RegisterBenchInput other = synthetic_kinect_v2_input();
  other.calibration.depth.width = 500;
  EXPECT_FALSE(run_register_bench({synthetic_kinect_v2_input(), other}, kShort).ok());
  EXPECT_FALSE(run_register_bench({other}, kShort).ok());  // not its calibration's size
}

TEST(RegisterBench, a_recording_that_is_not_there_is_refused) {
  EXPECT_EQ(recorded_input("rig:/nowhere#s0", 3).error().code, ErrorCode::kNotFound);
}

TEST(RegisterBench, prints_the_same_rows_as_table_and_json) {
  const RegisterBenchReport report{512, 424, 1920, 1080, {{"room", "fast", 4, 250, 3.5, 0.875}}};
  std::ostringstream json_text, table;
  print_json(report, json_text);
  const auto json = nlohmann::json::parse(json_text.str());
  EXPECT_EQ(json["color_width"], 1920);
  EXPECT_EQ(json["rows"][0]["input"], "room");
  EXPECT_EQ(json["rows"][0]["frames_per_cpu_s"], 250);
  print_table(report, table);
  EXPECT_NE(table.str().find("1920x1080 colour into 512x424 depth"), std::string::npos);
  EXPECT_NE(table.str().find("250"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
