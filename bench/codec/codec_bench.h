// SPDX-License-Identifier: Apache-2.0
// `roomcast bench codec`: bytes on the wire and CPU time for one sensor's frames. Compares the
// project's modes with peers, all in one run on one thread.
//
// Steady state: the first second (at most a third of the frames) is warm-up and not measured. Every
// codec is asked for a key frame at the start and every four seconds. Bytes per frame are those of
// a stream with a key frame every four seconds: one key frame (of the measured ones, else the
// first) and the mean of the others. Times are CPU milliseconds of the calling thread, means over
// the measured frames. Errors are means over the measured frames: measure/depth_error.h,
// measure/truth_motion.h, measure/luma_error.h.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/codec/bench_input.h"
#include "bench/codec/codec_choice.h"
#include "roomcast/codec/frame_codec.h"

namespace roomcast::bench {

struct CodecBenchOptions {
  std::string only;                               // a codec or a mode; empty: all
  int color_kbit_per_s = codec::kUsualColorKbit;  // for colour codecs with rate control
  int most_frames = 300;
  std::vector<double> target_mbit = {};   // rates of additional rows
  std::vector<CodecChoice> choices = {};  // instead of `only` and `target_mbit`, if not empty
  double warm_up_s = 1;
  double key_every_s = 4;
};

struct DepthQuality {
  double rms_input_mm = 0;
  int max_input_mm = 0;
  std::optional<double> rms_truth_mm, rms_truth_static_mm, rms_truth_slow_mm, rms_truth_moving_mm;
  // Against the noise-free reading, which is the best that a codec can restore.
  std::optional<double> rms_noise_free_static_mm, rms_noise_free_slow_mm, rms_noise_free_moving_mm;
  // Against the median of still surfaces, of the output and of the input (measure/depth_error.h).
  std::optional<double> rms_still_mm, rms_still_input_mm;
  // Per frame, against the truth where it is known, else against the input.
  double outliers_20mm = 0;
  // Readings per frame that only the input has, and that only the output has.
  double lost = 0, extra = 0;
};

struct CodecBenchRow {
  std::string codec, mode;
  std::string curve = {};                   // CodecChoice::curve
  double depth_bytes = 0, color_bytes = 0;  // per frame, including key frames
  double key_bytes = 0, delta_bytes = 0;  // depth and colour, of a key frame and of any other frame
  double depth_bits_per_pixel = 0;
  double mb_per_s = 0;  // at 30 frames per second, whatever the input's rate
  double encode_ms = 0, decode_ms = 0;
  std::optional<DepthQuality> depth;  // for codecs that carry depth
  // Empty for lossless codecs and without colour.
  std::optional<double> color_psnr_y;  // where the input sees colour and the decoder shows it
  std::optional<double> color_psnr_surface_y;  // of these, where depth is on the measured surface
  std::optional<double> color_psnr_all_y;      // wherever the input sees colour
  std::optional<double> color_psnr_input_y;    // as color_psnr_y, against the noisy input
  double color_lost = 0;  // seen pixels per frame that the decoder does not show
};

struct CodecBenchReport {
  std::string input;
  int frames = 0, measured_frames = 0, width = 0, height = 0;
  double fps = 0, key_every_s = 0;
  ColorReference color_reference = ColorReference::kInput;
  std::optional<double> moving_share, slow_share;  // of the pixels with known truth
  std::vector<CodecBenchRow> rows;
};

/// `progress` (may be empty) is called before every frame. kInvalidArgument: there is no frame, the
/// frame size changes, or `only` names no codec. Errors of the codecs are passed on, and a codec
/// that breaks its promise is an error too. A codec that does not support this frame size has no
/// row.
[[nodiscard]] Result<CodecBenchReport> run_codec_bench(
    BenchInput& input, const CodecBenchOptions& options = {},
    const std::function<void(int frame)>& progress = {});

void print_table(const CodecBenchReport& report, std::ostream& out);
/// One JSON object with the keys of `roomcast bench codec --json`.
void print_json(const CodecBenchReport& report, std::ostream& out);

}  // namespace roomcast::bench
