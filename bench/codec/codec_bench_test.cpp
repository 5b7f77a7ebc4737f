// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/codec_bench.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/codec/candidate.h"
#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::bench {
namespace {

constexpr int kWidth = 64, kHeight = 48;

/// A synthetic sensor with `count` frames.
class InputFixture final : public BenchInput {
 public:
  explicit InputFixture(int count) : count_(count) {}
  std::string name() const override { return "made up"; }
  double fps() const override { return 30; }
  ColorReference color_reference() const override { return ColorReference::kInput; }
  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    if (made_ == count_) return false;
    codec::SyntheticFrame made =
        codec::synthetic_frame(kWidth + (growing ? made_ : 0), kHeight, made_);
    ++made_;
    frame.depth_mm = made.depth_mm;
    frame.color = with_color ? made.color : ColorImage();
    frame.seen = with_color ? made.seen : MaskImage();
    truth.color = frame.color;
    truth.depth_mm = with_truth ? DepthImage(kWidth, kHeight, 2000) : DepthImage();
    return true;
  }
  bool with_color = false, with_truth = false, growing = false;

 private:
  const int count_;
  int made_ = 0;
};

const CodecBenchRow& row_named(const CodecBenchReport& report, const std::string& codec,
                               const std::string& mode) {
  for (const CodecBenchRow& row : report.rows) {
    if (row.codec == codec && row.mode == mode) return row;
  }
  ADD_FAILURE() << "no row " << codec << " " << mode;
  return report.rows.front();
}

/// Uses a fixed size for key frames and another for all other frames. The decoded depth is off by
/// `error` everywhere.
class FixedCodec final : public CodecUnderTest {
 public:
  explicit FixedCodec(int error) : error_(error) {}
  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    decoded.depth_mm = frame.depth_mm;
    for (std::size_t i = 0; i < frame.depth_mm.view().pixel_count(); ++i) {
      decoded.depth_mm.data()[i] = static_cast<std::uint16_t>(decoded.depth_mm.data()[i] + error_);
    }
    return FrameCost{want_key ? 1000u : 100u, want_key ? 500u : 50u, 2, 1};
  }

 private:
  int error_;
};

Candidate fixed_candidate(int error, std::optional<int> bound_mm) {
  return {{"fixed", "mode", false, bound_mm, {}}, std::make_unique<FixedCodec>(error)};
}
const BenchFrame kFlat{DepthImage(4, 4, 1000), {}, {}};

TEST(Candidate, bytes_are_those_of_a_stream_with_keys_at_their_interval) {
  Candidate candidate = fixed_candidate(0, 0);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(candidate.run(kFlat, {}, {}, i == 0).ok());
  const CodecBenchRow row = candidate.row(3, 100);
  EXPECT_DOUBLE_EQ(row.depth_bytes, (1000 + 99 * 100) / 100.0);
  EXPECT_DOUBLE_EQ(row.color_bytes, (500 + 99 * 50) / 100.0);
  EXPECT_DOUBLE_EQ(row.key_bytes, 1500);
  EXPECT_DOUBLE_EQ(row.delta_bytes, 150);
  EXPECT_DOUBLE_EQ(row.mb_per_s, (row.depth_bytes + row.color_bytes) * 30 / 1e6);
  EXPECT_DOUBLE_EQ(row.encode_ms, 2);
  EXPECT_DOUBLE_EQ(row.decode_ms, 1);
}

TEST(Candidate, is_refused_when_it_breaks_its_bound) {
  EXPECT_TRUE(fixed_candidate(2, 2).run(kFlat, {}, {}, true).ok());
  EXPECT_FALSE(fixed_candidate(3, 2).run(kFlat, {}, {}, true).ok());
  EXPECT_FALSE(fixed_candidate(-1000, 2).run(kFlat, {}, {}, true).ok()) << "readings lost";
  EXPECT_TRUE(fixed_candidate(30, {}).run(kFlat, {}, {}, true).ok());
}

TEST(CodecBench, counts_the_bytes_of_each_codec) {
  InputFixture input(3);
  input.with_color = true;
  const auto report = run_codec_bench(input);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->frames, 3);
  EXPECT_EQ(report->measured_frames, 2) << "a third is warm-up";
  const CodecBenchRow& raw = row_named(*report, "raw", "lossless");
  EXPECT_EQ(raw.depth_bytes, 2 * kWidth * kHeight);
  EXPECT_EQ(raw.color_bytes, 3 * kWidth * kHeight);
  EXPECT_DOUBLE_EQ(raw.mb_per_s, 5 * kWidth * kHeight * 30 / 1e6);
  EXPECT_DOUBLE_EQ(raw.depth_bits_per_pixel, 16);
  EXPECT_FALSE(raw.color_psnr_y.has_value()) << "nothing is lost";
  const CodecBenchRow& ours = row_named(*report, "roomcast", "lossless");
  EXPECT_LT(ours.depth_bytes, row_named(*report, "rvl", "lossless").depth_bytes);
  EXPECT_EQ(ours.depth.value().max_input_mm, 0);
  EXPECT_GT(ours.encode_ms, 0);
  const CodecBenchRow& color = row_named(*report, "roomcast", "color");
  EXPECT_GT(color.color_bytes, 0);
  EXPECT_LT(color.color_bytes, raw.color_bytes / 10);
  EXPECT_FALSE(color.depth.has_value());
  EXPECT_GT(color.color_psnr_y.value(), 25);
  EXPECT_EQ(color.color_psnr_y, color.color_psnr_all_y) << "it hides nothing";
  EXPECT_EQ(color.color_psnr_y, color.color_psnr_surface_y) << "it has no depth to be wrong";
}

TEST(CodecBench, colour_without_a_reading_counts_separately) {
  // Where a surface appears in one frame only, the live codec keeps the previous depth and colour.
  InputFixture input(4);
  input.with_color = true;
  const auto report = run_codec_bench(input, {.only = "live+color"});
  ASSERT_TRUE(report.ok()) << report.error().message;
  const CodecBenchRow& live = report->rows.front();
  ASSERT_TRUE(live.color_psnr_all_y.has_value());
  EXPECT_GE(live.color_psnr_surface_y.value(), live.color_psnr_y.value());
  EXPECT_GE(live.color_psnr_y.value(), live.color_psnr_all_y.value());
}

TEST(CodecBench, leaves_out_colour_codecs_where_there_is_no_colour) {
  InputFixture input(2);
  const auto report = run_codec_bench(input);
  ASSERT_TRUE(report.ok());
  for (const CodecBenchRow& row : report->rows) EXPECT_EQ(row.color_bytes, 0) << row.codec;
}

TEST(CodecBench, compares_with_the_truth_where_it_is_known) {
  InputFixture input(3);
  input.with_truth = true;
  const auto report = run_codec_bench(input);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->moving_share.value(), 0);
  const CodecBenchRow& raw = row_named(*report, "raw", "lossless");
  EXPECT_TRUE(raw.depth->rms_truth_static_mm.has_value());
  EXPECT_GT(raw.depth->outliers_20mm, 0);
  EXPECT_EQ(raw.depth->outliers_20mm,
            row_named(*report, "roomcast", "lossless").depth->outliers_20mm);
}

TEST(CodecBench, runs_one_codec_or_one_mode_alone) {
  InputFixture input(1), same_input(1), again(1);
  const auto codec = run_codec_bench(input, {.only = "rvl"});
  ASSERT_TRUE(codec.ok());
  EXPECT_EQ(codec->rows.size(), 1u);
  const auto mode = run_codec_bench(same_input, {.only = "lossless"});
  ASSERT_TRUE(mode.ok());
  for (const CodecBenchRow& row : mode->rows) EXPECT_EQ(row.mode, "lossless");
  EXPECT_FALSE(run_codec_bench(again, {.only = "no such"}).ok());
}

TEST(CodecBench, prints_the_promised_keys) {
  InputFixture input(1);
  input.with_color = true;
  std::ostringstream json_text, table;
  const auto report = run_codec_bench(input).value();
  print_json(report, json_text);
  const auto json = nlohmann::json::parse(json_text.str());
  EXPECT_EQ(json["input"], "made up");
  EXPECT_EQ(json["frames"], 1);
  ASSERT_GE(json["rows"].size(), 10u);
  for (const auto& row : json["rows"]) {
    for (const char* key : {"codec", "mode", "depth_bytes", "color_bytes", "mb_per_s", "encode_ms",
                            "decode_ms", "rms_input_mm", "max_input_mm", "rms_truth_mm",
                            "rms_truth_static_mm", "rms_truth_moving_mm", "outliers_20mm",
                            "color_psnr_y", "color_psnr_surface_y", "color_psnr_all_y"}) {
      EXPECT_TRUE(row.contains(key)) << key;
    }
  }
  EXPECT_EQ(json["rows"][0]["codec"], "raw");
  print_table(report, table);
  EXPECT_NE(table.str().find("roomcast"), std::string::npos);
}

TEST(CodecBench, refuses_no_frames_and_frames_of_two_sizes) {
  InputFixture empty(0), growing(2);
  growing.growing = true;
  EXPECT_FALSE(run_codec_bench(empty).ok());
  EXPECT_FALSE(run_codec_bench(growing).ok());
}

}  // namespace
}  // namespace roomcast::bench
