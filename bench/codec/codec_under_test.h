// SPDX-License-Identifier: Apache-2.0
// Interface of a codec in `roomcast bench codec`.
#pragma once

#include <cstddef>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

/// Depth, and colour in its grid with a mask. Colour and mask are both present or both empty.
struct BenchFrame {
  DepthImage depth_mm;
  ColorImage color;
  MaskImage seen;
};

/// Properties shared by all frames of a run.
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
  /// Encodes and decodes one frame on the calling thread. With `want_key` the frame must be
  /// decodable without earlier frames. Fields that the codec does not carry stay empty in
  /// `decoded`.
  virtual Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) = 0;
};

}  // namespace roomcast::bench
