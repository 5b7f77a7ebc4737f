// SPDX-License-Identifier: Apache-2.0
// Decodes live depth: sections of codec 2. docs/spec/codec.md. Any bytes are
// safe; work is bounded by the picture's size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/live/live_section.h"
#include "roomcast/codec/live/live_state.h"
#include "roomcast/codec/live/picture_pass.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class LiveDepthDecoder {
 public:
  /// Every pixel of `depth_mm` is written. kMalformed: damaged, or a frame that
  /// builds on one that was not decoded; the picture is then not to be shown,
  /// and if the frame was a reference only a key frame helps. kUnsupported: of
  /// a later version.
  Status decode(std::span<const std::uint8_t> section, ImageView<std::uint16_t> depth_mm);

  /// What the last frame left; for tests that compare it with the encoder's.
  [[nodiscard]] const LiveState& state() const { return state_; }

 private:
  std::uint32_t decode_pass(LiveReader& reader, LiveContexts& contexts, int step, bool reference,
                            std::uint16_t* shown_mm);
  std::uint32_t decode_key(LiveReader& reader, const LiveSectionHead& head);
  std::uint32_t decode_non_reference(LiveReader& reader, const LiveSectionHead& head,
                                     ImageView<std::uint16_t> depth_mm);

  LiveState state_;
  PassScratch scratch_;
  LiveContexts passing_contexts_;  // of a frame that is no reference
  bool in_step_ = false;           // the state is that of the encoder
};

}  // namespace roomcast::codec
