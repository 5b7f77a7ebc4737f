// SPDX-License-Identifier: Apache-2.0
// Selects the 16x16 blocks of a colour picture to spend bits on in a frame. A frame of layer 1 or
// up codes only blocks that changed since the layer-0 frame that it depends on: any other
// improvement would be lost with the frame. A layer-0 frame also codes blocks that changed lately,
// until they have the quantiser's quality. When the quantiser has become finer, still blocks can be
// coded again, a band of the picture in each layer-0 frame. A frame leaves out blocks that no
// viewer needs, and a block that changed meanwhile is coded once a viewer needs it.
// Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

class ColorActivity {
 public:
  static constexpr int kSide = 16;   // of a block, pixels
  static constexpr int kBands = 12;  // of rows of blocks

  /// Takes the next frame. `changed` has one entry for each 8x8 pixels, not 0 where the picture
  /// differs from the newest frame of layer 0. Returns one entry for each 16x16 pixels, 1 where the
  /// frame should spend bits; valid until the next call. Always the same size; the first role is a
  /// key frame's. `left_out` is not 0 for the 16x16 pixels that nobody needs of this frame; empty:
  /// all are needed.
  MaskView update(MaskView changed, FrameRole role, MaskView left_out = {});

  /// All still blocks are coded again, in the next kBands frames of layer 0.
  void improve_still_blocks() { next_band_ = 0; }
  /// Whether that is still going on.
  [[nodiscard]] bool is_improving() const { return next_band_ < kBands; }

 private:
  void improve_next_band();

  Image<std::uint8_t> active_;
  Image<std::uint8_t> improvements_left_;  // per block: layer-0 frames that may still improve it
  Image<std::uint8_t> owed_;  // per block: 1 after a change that a layer-0 frame left out
  int next_band_ = kBands;
};

}  // namespace roomcast::codec
