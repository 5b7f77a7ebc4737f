// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/codec_bench.h"

#include <algorithm>
#include <cmath>

#include "bench/codec/candidate.h"
#include "bench/codec/measure/truth_motion.h"

namespace roomcast::bench {
namespace {

Result<std::vector<Candidate>> make_candidates(const BenchPicture& picture, bool has_color,
                                               const CodecBenchOptions& options) {
  std::vector<Candidate> candidates;
  std::vector<CodecChoice> choices =
      options.choices.empty() ? codec_choices(options.only, options.target_mbit) : options.choices;
  for (CodecChoice& choice : choices) {
    if (choice.needs_color && !has_color) continue;
    auto made = choice.make(picture);
    if (made.ok()) {
      candidates.emplace_back(std::move(choice), std::move(*made));
    } else if (made.error().code != ErrorCode::kUnsupported) {
      return made.error();
    }
  }
  if (candidates.empty()) {
    return Error{ErrorCode::kInvalidArgument,
                 "No codec or mode is called \"" + options.only + "\"."};
  }
  return candidates;
}

Status check_frame(const BenchFrame& frame, const CodecBenchReport& report) {
  if (frame.depth_mm.width() != report.width || frame.depth_mm.height() != report.height) {
    return Error{ErrorCode::kInvalidArgument, "The frames of " + report.input + " differ in size."};
  }
  if (!frame.color.empty() && (!same_size(frame.color.view(), frame.depth_mm.view()) ||
                               !same_size(frame.seen.view(), frame.depth_mm.view()))) {
    return Error{ErrorCode::kInvalidArgument,
                 "The colour of " + report.input + " is not registered."};
  }
  return {};
}

/// Measures the share of moving pixels.
class MotionShare {
 public:
  void add(ImageView<const Motion> motion) {
    for (int y = 0; y < motion.height; ++y) {
      for (int x = 0; x < motion.width; ++x) ++count_[static_cast<std::size_t>(motion.at(x, y))];
    }
  }
  [[nodiscard]] std::optional<double> of(Motion motion) const {
    const std::int64_t all = count_[0] + count_[1] + count_[2];
    if (all == 0) return std::nullopt;
    return static_cast<double>(count_[static_cast<std::size_t>(motion)]) / static_cast<double>(all);
  }

 private:
  std::array<std::int64_t, kMotionCount> count_{};
};

class CodecBench {
 public:
  CodecBench(BenchInput& input, const CodecBenchOptions& options)
      : options_(options),
        key_interval_(
            std::max(1, static_cast<int>(std::lround(options.key_every_s * input.fps())))),
        motion_(input.fps()) {
    report_.input = input.name();
    report_.fps = input.fps();
    report_.key_every_s = options.key_every_s;
    report_.color_reference = input.color_reference();
  }

  Status add(const BenchFrame& frame, const BenchTruth& truth) {
    if (report_.frames == 0) {
      if (Status s = begin(frame); !s.ok()) return s;
    }
    if (Status s = check_frame(frame, report_); !s.ok()) return s;
    if (!truth.depth_mm.empty()) {
      motion_.add(truth.depth_mm);
      motion_share_.add(motion_.motion());
    }
    const bool key = report_.frames % key_interval_ == 0;
    for (Candidate& candidate : candidates_) {
      if (Status s = candidate.run(frame, truth, motion_.motion(), key); !s.ok()) return s;
    }
    ++report_.frames;
    return {};
  }

  Result<CodecBenchReport> finish() {
    if (report_.frames == 0) {
      return Error{ErrorCode::kInvalidArgument, report_.input + " has no frame to measure."};
    }
    const int warm_up = std::min(static_cast<int>(std::lround(options_.warm_up_s * report_.fps)),
                                 report_.frames / 3);
    report_.measured_frames = report_.frames - warm_up;
    report_.moving_share = motion_share_.of(Motion::kMoving);
    report_.slow_share = motion_share_.of(Motion::kSlow);
    for (const Candidate& candidate : candidates_) {
      CodecBenchRow row = candidate.row(warm_up, key_interval_);
      row.depth_bits_per_pixel = row.depth_bytes * 8 / (report_.width * report_.height);
      report_.rows.push_back(std::move(row));
    }
    return std::move(report_);
  }

  [[nodiscard]] int frames() const { return report_.frames; }

 private:
  Status begin(const BenchFrame& frame) {
    report_.width = frame.depth_mm.width();
    report_.height = frame.depth_mm.height();
    auto made =
        make_candidates({report_.width, report_.height, report_.fps, options_.color_kbit_per_s},
                        !frame.color.empty(), options_);
    if (!made.ok()) return made.error();
    candidates_ = std::move(*made);
    return {};
  }

  const CodecBenchOptions options_;
  const int key_interval_;
  TruthMotion motion_;
  MotionShare motion_share_;
  std::vector<Candidate> candidates_;
  CodecBenchReport report_;
};

}  // namespace

Result<CodecBenchReport> run_codec_bench(BenchInput& input, const CodecBenchOptions& options,
                                         const std::function<void(int frame)>& progress) {
  CodecBench bench(input, options);
  BenchFrame frame;
  BenchTruth truth;
  while (bench.frames() < options.most_frames) {
    if (progress) progress(bench.frames() + 1);
    const auto more = input.next(frame, truth);
    if (!more.ok()) return more.error();
    if (!*more) break;
    if (Status s = bench.add(frame, truth); !s.ok()) return s.error();
  }
  return bench.finish();
}

}  // namespace roomcast::bench
