// SPDX-License-Identifier: Apache-2.0
#include "bench/render/frame_times.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/render/striped_rig_fixture.h"

namespace roomcast::bench {
namespace {

using FrameTimesTest = StripedRigTest;

TEST(SpreadTest, is_median_and_95th_percentile) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  EXPECT_EQ(spread_of(values).median, 50);
  EXPECT_EQ(spread_of(values).p95, 95);
  EXPECT_EQ(spread_of({7}).p95, 7);
}

TEST_F(FrameTimesTest, are_measured_for_each_mode_and_number_of_sensors) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  FrameTimesOptions options{.rig = folder / "rig"};
  options.sensors = {1, 3};
  options.eye_pixels = 64;
  options.frame_sets = 2;
  const auto report = run_frame_times(options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->rows.size(), 2 * render::kRenderModes.size());
  EXPECT_EQ(report->rows.front().sensors, 1);
  EXPECT_EQ(report->rows.back().sensors, 3);
  for (const FrameTimesRow& row : report->rows) {
    EXPECT_GT(row.without_ms.median, 0) << row.mode;
    EXPECT_GT(row.gpu_ms.median, 0) << row.mode;
    EXPECT_GE(row.with_new_frames_ms.p95, row.with_new_frames_ms.median) << row.mode;
  }
  std::ostringstream json, table;
  print_json(*report, json);
  print_table(*report, table);
  EXPECT_EQ(nlohmann::json::parse(json.str()).at("rows").size(), report->rows.size());
  EXPECT_NE(table.str().find("64x64"), std::string::npos) << table.str();
}

TEST_F(FrameTimesTest, impossible_rooms_are_refused_before_anything_is_read) {
  FrameTimesOptions options{.rig = folder / "nothing"};
  options.sensors = {65};
  const auto report = run_frame_times(options, {});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kInvalidArgument) << report.error().message;
  options.sensors.clear();
  EXPECT_FALSE(options.check().ok());
}

}  // namespace
}  // namespace roomcast::bench
