// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/curves/rate_chart.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

CodecBenchRow row_of(const std::string& curve, double depth_bytes, double color_bytes) {
  CodecBenchRow row;
  row.curve = curve;
  row.depth_bytes = depth_bytes;
  row.color_bytes = color_bytes;
  return row;
}

/// Two rows of one curve, the larger one before the smaller, a row of colour alone, and a row that
/// belongs to no curve. 10 frames/s: 12 500 bytes a frame are 1 Mbit/s.
CodecBenchReport report_fixture() {
  CodecBenchReport report;
  report.fps = 10;
  report.rows = {row_of("a & b", 25'000, 0), row_of("a & b", 12'500, 0), row_of("c", 0, 1'250),
                 row_of("", 12'500, 12'500)};
  for (CodecBenchRow& row : report.rows) {
    row.depth = DepthQuality{};
    row.depth->rms_noise_free_moving_mm = 3;
  }
  report.rows[0].depth->rms_noise_free_moving_mm = 2;
  report.rows[2].depth.reset();
  report.rows[2].color_psnr_y = 36;
  return report;
}

TEST(RateChart, a_panel_has_each_curve_by_its_rate_and_none_is_empty) {
  const std::vector<RatePanel> panels = rate_panels(report_fixture());
  ASSERT_EQ(panels.size(), 2u);  // nothing is known of depth that stands still
  ASSERT_EQ(panels[0].curves.size(), 1u);
  const RateCurve& depth = panels[0].curves[0];
  EXPECT_EQ(depth.name, "a & b");
  ASSERT_EQ(depth.points.size(), 2u);
  EXPECT_DOUBLE_EQ(depth.points[0].mbit_per_s, 1);
  EXPECT_EQ(depth.points[0].value, 3);
  EXPECT_DOUBLE_EQ(depth.points[1].mbit_per_s, 2);
  ASSERT_EQ(panels[1].curves.size(), 1u);
  EXPECT_EQ(panels[1].curves[0].name, "c");
  EXPECT_NEAR(panels[1].curves[0].points[0].mbit_per_s, 0.1, 1e-12);
}

TEST(RateChart, colour_on_the_measured_surface_counts_where_it_is_known) {
  CodecBenchReport report = report_fixture();
  report.rows[2].color_psnr_surface_y = 38;
  EXPECT_EQ(rate_panels(report)[1].curves[0].points[0].value, 38);
}

TEST(RateChart, the_drawing_names_curves_once_and_escapes_what_it_names) {
  const std::string svg = rate_chart(rate_panels(report_fixture()), "1 < 2");
  EXPECT_EQ(svg.find("a & b"), std::string::npos);
  const std::size_t named = svg.find(">a &amp; b<");
  ASSERT_NE(named, std::string::npos);
  EXPECT_EQ(svg.find(">a &amp; b<", named + 1), std::string::npos);
  EXPECT_NE(svg.find("1 &lt; 2"), std::string::npos);
  EXPECT_EQ(svg.rfind("</svg>\n"), svg.size() - 7);
}

TEST(RateChart, values_of_one_height_have_a_place) {
  CodecBenchReport report = report_fixture();
  report.rows[0].depth->rms_noise_free_moving_mm = 3;
  const std::string svg = rate_chart(rate_panels(report), "");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(RateChart, without_a_panel_there_is_an_empty_drawing) {
  EXPECT_NE(rate_chart({}, "nothing").find("nothing"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
