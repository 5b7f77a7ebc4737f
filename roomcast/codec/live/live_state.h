// SPDX-License-Identifier: Apache-2.0
// State that a live depth encoder and its decoders keep from one reference frame to the next. It
// must be the same to the last bit on both sides. docs/spec/codec.md §2.4.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roomcast/codec/live/block_view.h"
#include "roomcast/codec/live/depth_domain.h"
#include "roomcast/codec/live/live_contexts.h"

namespace roomcast::codec {

/// Lowest coefficients of a coded surface; they predict those of neighbouring blocks.
struct SurfaceParameters {
  std::int32_t mean = 0, slope_x = 0, slope_y = 0;
  bool known = false;
};

enum class BlockActivity : std::uint8_t { kSkipped = 0, kMixed = 1, kUniform = 2 };

/// Properties of a coded block that later blocks use.
struct BlockTrace {
  BlockActivity activity = BlockActivity::kSkipped;
  std::array<SurfaceParameters, 2> surfaces;
};

struct LiveState {
  BlockGrid grid;
  DepthDomain domain;
  std::vector<std::uint16_t> picture;     // levels, 0 = no reading
  std::vector<std::uint16_t> picture_mm;  // the same in millimetres
  std::vector<std::uint16_t> background;  // levels, the last static picture of each block
  std::vector<std::uint8_t> static_age;  // per block: consecutive reference frames without a change
  std::vector<BlockTrace> trace;         // per block: of the newest reference frame
  LiveContexts contexts;
  std::uint32_t hash = 0;

  void resize(int width, int height);
  /// Clears the state for a key frame with these levels. Keeps memory.
  void begin_anew(const SigmaCodes& sigma);
  void remember_picture_as_background() { background = picture; }
};

}  // namespace roomcast::codec
