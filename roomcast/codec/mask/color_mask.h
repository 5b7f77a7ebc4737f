// SPDX-License-Identifier: Apache-2.0
// Codes the colour mask of a stream of frames: key frames contain the whole mask (codec 1), other
// frames the changes from the reference mask, that of the newest layer-0 frame (codec 2).
// docs/spec/codec.md §3.2 and §3.3. Both sides keep the reference. Single-threaded.
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
  /// Appends the bytes of a section: codec 1 for key frames, else codec 2. Always the same size;
  /// the first role is a key frame's. `depth_mm` is the depth that decoders will have.
  void encode(MaskView mask, DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out);

  /// Appends a section of codec 2 that makes decoders show the reference mask again and changes no
  /// state. Not for key frames.
  static void repeat(std::vector<std::uint8_t>& out) { out.push_back(0); }

 private:
  MaskImage reference_, now_;  // 0 and 1
};

class ColorMaskDecoder {
 public:
  /// Fills `mask` with 0 and 255; 0 where `depth_mm` is 0. Always the same size. kMalformed for
  /// changes without an earlier mask.
  [[nodiscard]] Status decode(std::uint8_t codec, std::span<const std::uint8_t> section,
                              DepthView depth_mm, ImageView<std::uint8_t> mask);

 private:
  MaskImage reference_, now_;
};

}  // namespace roomcast::codec
