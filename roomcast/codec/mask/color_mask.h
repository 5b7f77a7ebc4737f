// SPDX-License-Identifier: Apache-2.0
// The colour mask section of a stream of frames: key frames carry the mask by itself (codec 1), the
// others what changed since the reference mask, that of the newest layer-0 frame (codec 2).
// docs/spec/codec.md §3.2. Both sides keep the reference. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

class ColorMaskEncoder {
 public:
  /// Appends the bytes of a section of codec 1, for key frames, or 2. Always the same size; the
  /// first role is a key frame's. `depth_mm` is what decoders will have.
  void encode(MaskView mask, DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out);

  /// Appends a section of codec 2 after which decoders show the reference mask once more; it leaves
  /// no trace. Not for key frames.
  static void repeat(std::vector<std::uint8_t>& out) { out.push_back(0); }

 private:
  MaskImage reference_, now_;  // 0 and 1
};

class ColorMaskDecoder {
 public:
  /// Fills `mask` with 0 and 255; 0 where `depth_mm` is 0. Always the same size. kMalformed for
  /// changes without a mask before them.
  [[nodiscard]] Status decode(std::uint8_t codec, std::span<const std::uint8_t> section,
                              DepthView depth_mm, ImageView<std::uint8_t> mask);

 private:
  MaskImage reference_, now_;
};

}  // namespace roomcast::codec
