// SPDX-License-Identifier: Apache-2.0
// Memory that one pass over a live depth picture needs, kept from frame to frame.
#pragma once

#include <vector>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/live_state.h"

namespace roomcast::codec {

struct PassScratch {
  std::vector<BlockTrace> trace;        // of the blocks of this frame
  std::vector<PixelLabel> labels;       // of this frame's pixels, with a margin of one
  std::vector<std::uint16_t> shown_mm;  // the decoded frame if it is no reference

  void resize(const LiveState& state) {
    trace.resize(state.block_count());
    labels.resize(static_cast<std::size_t>(state.width + 2) *
                  static_cast<std::size_t>(state.height + 1));
  }
};

}  // namespace roomcast::codec
