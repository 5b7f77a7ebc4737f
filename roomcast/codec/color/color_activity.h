// SPDX-License-Identifier: Apache-2.0
// Which 16x16 blocks of a colour picture are worth bits in a frame. A frame that leaves no trace
// shows what changed since the frame it builds on and leaves the rest as that showed it: anything
// it made better would be lost again with it. A frame that others build on also goes on with what
// changed lately, until that is as good as the quantiser makes it. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

class ColorActivity {
 public:
  static constexpr int kSide = 16;  // of a block, pixels

  /// The next frame. `changed` has one entry for each 8x8 pixels, not 0 where the picture is not
  /// that of the newest frame of layer 0. One entry for each 16x16 pixels, 1 where the frame is to
  /// spend bits; valid until the next call. Always the same size; the first role is a key frame's.
  MaskView update(MaskView changed, FrameRole role);

 private:
  Image<std::uint8_t> active_;
  Image<std::uint8_t> improvements_left_;  // frames of layer 0 that still may
};

}  // namespace roomcast::codec
