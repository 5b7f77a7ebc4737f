// SPDX-License-Identifier: Apache-2.0
// A codec under test and its per-frame measurements.
#pragma once

#include <memory>
#include <vector>

#include "bench/codec/bench_input.h"
#include "bench/codec/codec_bench.h"
#include "bench/codec/codec_choice.h"
#include "bench/codec/measure/depth_error.h"
#include "bench/codec/measure/luma_error.h"

namespace roomcast::bench {

class Candidate {
 public:
  Candidate(CodecChoice choice, std::unique_ptr<CodecUnderTest> codec)
      : choice_(std::move(choice)), codec_(std::move(codec)) {}

  /// Encodes, decodes and measures one frame. kMalformed: the decoded frame breaks the codec's
  /// promise.
  Status run(const BenchFrame& frame, const BenchTruth& truth, ImageView<const Motion> motion,
             bool key);

  /// Averages over all frames from `first` on, for a stream with one key frame in `key_interval`
  /// frames.
  [[nodiscard]] CodecBenchRow row(int first, int key_interval) const;

 private:
  struct Measured {
    bool key = false;
    FrameCost cost;
    DepthError depth;
    LumaError color, color_on_surface, color_all, color_to_input;
    std::int64_t color_lost = 0;
  };
  void compare_color(const BenchFrame& frame, const BenchTruth& truth, Measured& now);
  /// Sets shown_ to the pixels that are seen in the input and shown by the decoder. Returns the
  /// number of seen pixels that are not shown.
  std::int64_t find_shown(const MaskImage& seen, const MaskImage& decoded);
  /// Keeps only those pixels of shown_ whose decoded depth is on the measured surface, because the
  /// reference is the colour of that surface.
  void keep_measured_surface(DepthView measured_mm);
  [[nodiscard]] Status check_promise(const DepthImage& input_mm, const DepthError& error) const;
  void add_bytes(int first, int key_interval, CodecBenchRow& row) const;
  void add_quality(int first, CodecBenchRow& row) const;

  CodecChoice choice_;
  std::unique_ptr<CodecUnderTest> codec_;
  BenchFrame decoded_;
  MaskImage shown_;
  std::vector<Measured> frames_;
};

}  // namespace roomcast::bench
