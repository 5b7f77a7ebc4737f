// SPDX-License-Identifier: Apache-2.0
#include "bench/codec_bench.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/codec/synthetic_color.h"

namespace roomcast::bench {
namespace {

constexpr int kWidth = 64, kHeight = 48;

/// `count` frames; with colour or without.
CodecBenchFeed feed_of(int count, bool with_color) {
  return [=, i = 0](DepthImage& depth, ColorImage& color, MaskImage& seen) mutable {
    if (i == count) return false;
    codec::SyntheticFrame frame = codec::synthetic_frame(kWidth, kHeight, i++);
    depth = frame.depth_mm;
    color = with_color ? frame.color : ColorImage();
    seen = with_color ? frame.seen : MaskImage();
    return true;
  };
}

const CodecBenchRow& row_named(const CodecBenchReport& report, const std::string& codec) {
  for (const CodecBenchRow& row : report.rows) {
    if (row.codec == codec) return row;
  }
  ADD_FAILURE() << "no row " << codec;
  return report.rows.front();
}

TEST(CodecBench, counts_what_each_codec_sends) {
  const auto report = run_codec_bench("made up", feed_of(3, true));
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->frames, 3);
  const CodecBenchRow& raw = row_named(*report, "raw");
  EXPECT_EQ(raw.depth_bytes, 2 * kWidth * kHeight);
  EXPECT_EQ(raw.color_bytes, 3 * kWidth * kHeight);
  EXPECT_DOUBLE_EQ(raw.mb_per_s, 5 * kWidth * kHeight * 30 / 1e6);
  const CodecBenchRow& ours = row_named(*report, "roomcast");
  EXPECT_LT(ours.depth_bytes, row_named(*report, "rvl").depth_bytes);
  EXPECT_LT(ours.depth_bytes, row_named(*report, "gzip").depth_bytes);
  EXPECT_GT(ours.color_bytes, 0);
  EXPECT_LT(ours.color_bytes, raw.color_bytes / 10);
  EXPECT_EQ(ours.max_input_mm, 0);
  EXPECT_GT(ours.color_psnr_y.value(), 25);
  EXPECT_GT(ours.encode_ms, 0);
  EXPECT_FALSE(raw.color_psnr_y.has_value()) << "nothing is lost";
}

TEST(CodecBench, runs_without_colour) {
  const auto report = run_codec_bench("made up", feed_of(2, false));
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(row_named(*report, "roomcast").color_bytes, 0);
  EXPECT_FALSE(row_named(*report, "roomcast").color_psnr_y.has_value());
}

TEST(CodecBench, compares_with_the_truth_where_it_is_known) {
  const auto truth = [](DepthImage& truth_mm) { truth_mm = DepthImage(kWidth, kHeight, 2000); };
  const auto report = run_codec_bench("made up", feed_of(2, false), truth);
  ASSERT_TRUE(report.ok());
  const CodecBenchRow& raw = row_named(*report, "raw");
  EXPECT_TRUE(raw.rms_truth_mm.has_value());
  EXPECT_GT(raw.outliers_20mm, 0);
  EXPECT_EQ(raw.outliers_20mm, row_named(*report, "roomcast").outliers_20mm);
}

TEST(CodecBench, prints_the_promised_keys) {
  std::ostringstream json_text, table;
  const auto report = run_codec_bench("made up", feed_of(1, true)).value();
  print_json(report, json_text);
  const auto json = nlohmann::json::parse(json_text.str());
  EXPECT_EQ(json["input"], "made up");
  EXPECT_EQ(json["frames"], 1);
  ASSERT_EQ(json["rows"].size(), 4u);
  for (const char* key :
       {"codec", "mode", "depth_bytes", "color_bytes", "mb_per_s", "encode_ms", "decode_ms",
        "rms_input_mm", "max_input_mm", "rms_truth_mm", "rms_truth_static_mm",
        "rms_truth_moving_mm", "outliers_20mm", "color_psnr_y"}) {
    EXPECT_TRUE(json["rows"][0].contains(key)) << key;
  }
  print_table(report, table);
  EXPECT_NE(table.str().find("roomcast"), std::string::npos);
}

TEST(CodecBench, refuses_no_frames_and_frames_of_two_sizes) {
  EXPECT_FALSE(run_codec_bench("empty", feed_of(0, false)).ok());
  const CodecBenchFeed growing = [width = 32](DepthImage& depth, ColorImage&, MaskImage&) mutable {
    depth = DepthImage(width++, 32, 1000);
    return true;
  };
  EXPECT_FALSE(run_codec_bench("growing", growing).ok());
}

}  // namespace
}  // namespace roomcast::bench
