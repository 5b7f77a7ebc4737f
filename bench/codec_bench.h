// SPDX-License-Identifier: Apache-2.0
// `roomcast bench codec`: what one sensor's frames take on the wire and in CPU time, beside peers.
//   raw       depth as u16, colour as 8-bit RGB
//   gzip      what the paper sends: both through zlib, level 6 (Lesniak & Tucker 2018)
//   rvl       depth alone (Wilson 2017)
//   roomcast  the payload of docs/spec/codec.md; the colour mask counts as depth
// Times are CPU milliseconds of the calling thread per frame, means over all frames.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

/// Fills depth, colour in the depth grid and where it is seen; the latter two may be left empty.
/// False at the end.
using CodecBenchFeed =
    std::function<bool(DepthImage& depth_mm, ColorImage& registered, MaskImage& seen)>;
/// Fills the true depth of the frame that was fed last. Empty function: no truth is known.
using CodecBenchTruth = std::function<void(DepthImage& truth_mm)>;

struct CodecBenchOptions {
  double fps = 30;             // for mb_per_s and the colour's rate control
  int color_kbit_per_s = 900;  // of roomcast's colour
  int most_frames = 300;
};

struct CodecBenchRow {
  std::string codec, mode;
  double depth_bytes = 0, color_bytes = 0;  // per frame
  double depth_bits_per_pixel = 0;
  double mb_per_s = 0;
  double encode_ms = 0, decode_ms = 0;              // all that the row sends
  double depth_encode_ms = 0, depth_decode_ms = 0;  // depth alone
  double rms_input_mm = 0;
  int max_input_mm = 0;
  std::optional<double> rms_truth_mm, rms_truth_static_mm, rms_truth_moving_mm;
  double outliers_20mm = 0;            // per frame, against the truth where it is known
  std::optional<double> color_psnr_y;  // over seen pixels; nothing without loss or without colour
};

struct CodecBenchReport {
  std::string input;
  int frames = 0, width = 0, height = 0;
  std::vector<CodecBenchRow> rows;
};

/// kInvalidArgument when there is no frame or the size changes; errors of the codecs as they are. A
/// codec that does not give back what it promises is an error too.
[[nodiscard]] Result<CodecBenchReport> run_codec_bench(const std::string& input,
                                                       const CodecBenchFeed& feed,
                                                       const CodecBenchTruth& truth = {},
                                                       const CodecBenchOptions& options = {});

void print_table(const CodecBenchReport& report, std::ostream& out);
/// One JSON object with the keys of `roomcast bench codec --json`.
void print_json(const CodecBenchReport& report, std::ostream& out);

}  // namespace roomcast::bench
