// SPDX-License-Identifier: Apache-2.0
#include "bench/codec_bench.h"

#include <cmath>

#include "bench/codec_under_test.h"
#include "bench/depth_error.h"

namespace roomcast::bench {
namespace {

/// Luma error over seen pixels, summed over frames. BT.709 weights.
class LumaError {
 public:
  void add(const BenchFrame& frame, const BenchFrame& decoded) {
    if (frame.color.empty() || decoded.color.empty()) return;
    for (std::size_t i = 0; i < frame.seen.view().pixel_count(); ++i) {
      if (!frame.seen.data()[i]) continue;
      const double error = luma(frame.color.data()[i]) - luma(decoded.color.data()[i]);
      squares_ += error * error;
      ++count_;
    }
  }
  /// Nothing without a loss.
  [[nodiscard]] std::optional<double> psnr() const {
    if (count_ == 0 || squares_ == 0) return std::nullopt;
    return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count_) / squares_);
  }

 private:
  static double luma(Rgb8 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }
  double squares_ = 0;
  std::int64_t count_ = 0;
};

/// A codec and what was measured of it so far.
struct Candidate {
  std::unique_ptr<CodecUnderTest> codec;
  BenchFrame decoded;
  CodecBenchRow sums;
  DepthError depth_error;
  LumaError luma_error;
};

Status run_frame(const BenchFrame& frame, DepthView truth, DepthView previous_truth,
                 Candidate& candidate) {
  const auto cost = candidate.codec->run(frame, candidate.decoded);
  if (!cost.ok()) return cost.error();
  if (candidate.codec->mode() == "lossless" && !(candidate.decoded.depth_mm == frame.depth_mm)) {
    return Error{ErrorCode::kInvalidArgument,
                 candidate.codec->name() + " did not give back the depth that it was given."};
  }
  CodecBenchRow& sums = candidate.sums;
  sums.depth_bytes += static_cast<double>(cost->depth_bytes);
  sums.color_bytes += static_cast<double>(cost->color_bytes);
  sums.encode_ms += cost->encode_ms;
  sums.decode_ms += cost->decode_ms;
  sums.depth_encode_ms += cost->depth_encode_ms;
  sums.depth_decode_ms += cost->depth_decode_ms;
  candidate.depth_error.add(candidate.decoded.depth_mm, frame.depth_mm, truth, previous_truth);
  candidate.luma_error.add(frame, candidate.decoded);
  return {};
}

CodecBenchRow row_of(const Candidate& candidate, const CodecBenchReport& report, double fps) {
  CodecBenchRow row = candidate.sums;
  row.codec = candidate.codec->name();
  row.mode = candidate.codec->mode();
  for (double* sum : {&row.depth_bytes, &row.color_bytes, &row.encode_ms, &row.decode_ms,
                      &row.depth_encode_ms, &row.depth_decode_ms}) {
    *sum /= report.frames;
  }
  row.depth_bits_per_pixel = row.depth_bytes * 8 / (report.width * report.height);
  row.mb_per_s = (row.depth_bytes + row.color_bytes) * fps / 1e6;
  row.rms_input_mm = candidate.depth_error.rms_input_mm();
  row.max_input_mm = candidate.depth_error.max_input_mm();
  row.rms_truth_mm = candidate.depth_error.rms_truth_mm();
  row.rms_truth_static_mm = candidate.depth_error.rms_truth_static_mm();
  row.rms_truth_moving_mm = candidate.depth_error.rms_truth_moving_mm();
  row.outliers_20mm = candidate.depth_error.outliers_per_frame();
  row.color_psnr_y = candidate.luma_error.psnr();
  return row;
}

Result<std::vector<Candidate>> make_candidates(const BenchFrame& first,
                                               const CodecBenchOptions& options) {
  auto roomcast = make_roomcast(first.depth_mm.width(), first.depth_mm.height(), options.fps,
                                options.color_kbit_per_s);
  if (!roomcast.ok()) return roomcast.error();
  std::vector<Candidate> candidates(4);
  candidates[0].codec = make_raw();
  candidates[1].codec = make_gzip();
  candidates[2].codec = make_rvl();
  candidates[3].codec = std::move(*roomcast);
  return candidates;
}

Status check_frame(const BenchFrame& frame, const CodecBenchReport& report) {
  const bool has_color = !frame.color.empty();
  if (frame.depth_mm.width() != report.width || frame.depth_mm.height() != report.height) {
    return Error{ErrorCode::kInvalidArgument, "The frames of " + report.input + " differ in size."};
  }
  if (has_color && (!same_size(frame.color.view(), frame.depth_mm.view()) ||
                    !same_size(frame.seen.view(), frame.depth_mm.view()))) {
    return Error{ErrorCode::kInvalidArgument,
                 "The colour of " + report.input + " is not registered."};
  }
  return {};
}

}  // namespace

Result<CodecBenchReport> run_codec_bench(const std::string& input, const CodecBenchFeed& feed,
                                         const CodecBenchTruth& truth,
                                         const CodecBenchOptions& options) {
  CodecBenchReport report{input, 0, 0, 0, {}};
  std::vector<Candidate> candidates;
  BenchFrame frame;
  DepthImage truth_mm, previous_truth_mm;
  while (report.frames < options.most_frames && feed(frame.depth_mm, frame.color, frame.seen)) {
    if (report.frames == 0) {
      report.width = frame.depth_mm.width();
      report.height = frame.depth_mm.height();
      auto made = make_candidates(frame, options);
      if (!made.ok()) return made.error();
      candidates = std::move(*made);
    }
    if (Status s = check_frame(frame, report); !s.ok()) return s.error();
    std::swap(truth_mm, previous_truth_mm);
    if (truth) truth(truth_mm);
    for (Candidate& candidate : candidates) {
      if (Status s = run_frame(frame, truth_mm, previous_truth_mm, candidate); !s.ok())
        return s.error();
    }
    ++report.frames;
  }
  if (report.frames == 0) {
    return Error{ErrorCode::kInvalidArgument, input + " has no frame to measure."};
  }
  for (const Candidate& candidate : candidates) {
    report.rows.push_back(row_of(candidate, report, options.fps));
  }
  return report;
}

}  // namespace roomcast::bench
