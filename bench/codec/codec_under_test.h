// SPDX-License-Identifier: Apache-2.0
// One codec as `roomcast bench codec` sees it.
#pragma once

#include <cstddef>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

/// Depth, and colour in its grid with a mask; the latter two are empty or there both.
struct BenchFrame {
  DepthImage depth_mm;
  ColorImage color;
  MaskImage seen;
};

/// What the frames of a run have in common.
struct BenchPicture {
  int width = 0, height = 0;
  double fps = 30;
  int color_kbit_per_s = codec::kUsualColorKbit;  // for codecs with rate control
};

/// Bytes and CPU milliseconds of one frame.
struct FrameCost {
  std::size_t depth_bytes = 0, color_bytes = 0;
  double encode_ms = 0, decode_ms = 0;
};

class CodecUnderTest {
 public:
  virtual ~CodecUnderTest() = default;
  /// Encodes and decodes one frame, on the calling thread alone. With `want_key` it must be
  /// decodable without the frames before. What the codec does not carry is left empty in `decoded`.
  virtual Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) = 0;
};

}  // namespace roomcast::bench
