// SPDX-License-Identifier: Apache-2.0
// BlockNeed: how much of one block of a stream's pictures its viewers need. The encoder skips a
// block that a frame leaves out, which costs no bytes; decoders go on showing the block that they
// have.
#pragma once

#include <cstdint>

#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

enum class BlockNeed : std::uint8_t {
  kNothing,
  kShapeOnly,  // depth in frames of layer 0, and no colour
  kBaseOnly,   // frames of layer 0
  kAll,
};

/// One for each 8x8 pixels of depth, and for the colour there.
using BlockNeeds = Image<BlockNeed>;
using BlockNeedsView = ImageView<const BlockNeed>;

inline constexpr int kNeedSide = 8;  // of a block, pixels

/// The columns (or rows) of blocks of a picture so wide (or high).
[[nodiscard]] constexpr int need_blocks(int pixels) {
  return (pixels + kNeedSide - 1) / kNeedSide;
}

/// Whether a frame leaves out the block's depth. Key frames have everything.
[[nodiscard]] constexpr bool leaves_out_depth(BlockNeed need, FrameRole role) {
  if (role.key || need == BlockNeed::kAll) return false;
  return need == BlockNeed::kNothing || role.layer > 0;
}

/// Likewise its colour.
[[nodiscard]] constexpr bool leaves_out_color(BlockNeed need, FrameRole role) {
  return leaves_out_depth(need, role) || (need == BlockNeed::kShapeOnly && !role.key);
}

}  // namespace roomcast::codec
